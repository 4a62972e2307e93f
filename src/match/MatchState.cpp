#include "match/MatchState.h"

#include "base/File.h"
#include "simulation/world/World.h"
#include "streams/Json.h"

namespace gt {
namespace {

constexpr std::string_view digits = "0123456789abcdef";

}  // namespace

Result<MatchState> readMatchState(const std::string& path) {
  const auto text = readFile(path);
  if (!text) return text.error();
  MatchState state;
  if (const auto done = readJson(*text, path, state); !done) return done.error();
  if (state.time.ms < 0 || state.time.ms % tickMs != 0)
    return Error{.file = path, .field = "time", .what = "no tick ends then"};
  Time last;
  for (const Intervention& intervention : state.history) {
    if (intervention.time < last || intervention.time > state.time)
      return Error{.file = path, .field = "history", .what = "is not in the order of time"};
    last = intervention.time;
  }
  return state;
}

std::string hexOf(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) {
    text += digits[std::to_integer<std::size_t>(byte >> 4)];
    text += digits[std::to_integer<std::size_t>(byte & std::byte{15})];
  }
  return text;
}

std::vector<std::byte> bytesOf(std::string_view hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    const auto high = digits.find(hex[i]), low = digits.find(hex[i + 1]);
    bytes.push_back(static_cast<std::byte>((high & 15) << 4 | (low & 15)));
  }
  return bytes;
}

}  // namespace gt
