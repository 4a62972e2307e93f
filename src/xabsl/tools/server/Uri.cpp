#include "xabsl/tools/server/Uri.h"

#include <filesystem>
#include <string_view>

namespace xabsl::server {

std::string pathOf(const std::string& uri) {
  constexpr std::string_view scheme = "file://";
  if (uri.compare(0, scheme.size(), scheme) != 0) return uri;
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'                     ? c - '0'
           : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (c | 0x20) - 'a' + 10
                                                    : -1;
  };
  std::string path;
  for (std::size_t i = scheme.size(); i < uri.size(); ++i) {
    const bool coded =
        uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0;
    path += coded ? static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2])) : uri[i];
    if (coded) i += 2;
  }
  return std::filesystem::path(path).lexically_normal().generic_string();
}

std::string fileUri(const std::string& path) {
  constexpr std::string_view plain = "/-_.~", digits = "0123456789ABCDEF";
  std::string uri = "file://";
  for (const char c : path) {
    const unsigned char byte = static_cast<unsigned char>(c);
    const bool letter =
        (byte >= '0' && byte <= '9') || ((byte | 0x20u) >= 'a' && (byte | 0x20u) <= 'z');
    if (letter || plain.find(c) != std::string_view::npos)
      uri += c;
    else
      uri += {'%', digits[byte / 16], digits[byte % 16]};
  }
  return uri;
}

}  // namespace xabsl::server
