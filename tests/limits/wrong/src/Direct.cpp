#include <nlohmann/json.hpp>

nlohmann::json direct(const char* text) {
  return nlohmann::json::parse(text);
}
bool other(const char* text) {
  return nlohmann::ordered_json::accept(text);
}

constexpr int most = 60, least{2}, size = 3;
