#include "xabsl/tools/server/MessageReader.h"

#include <algorithm>
#include <charconv>

namespace xabsl::server {

namespace {

/// The number behind `Content-Length:` in a header, without regard to case.
std::optional<std::size_t> lengthOf(std::string_view header) {
  constexpr std::string_view key = "content-length:";
  while (!header.empty()) {
    std::string_view line = header.substr(0, header.find("\r\n"));
    header.remove_prefix(std::min(line.size() + 2, header.size()));
    const bool isLength =
        line.size() > key.size() &&
        std::equal(key.begin(), key.end(), line.begin(), [](char expected, char c) {
          return expected == (c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c);
        });
    if (!isLength) continue;
    line.remove_prefix(key.size());
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    std::size_t length = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), length);
    if (error != std::errc() || end != line.data() + line.size()) return std::nullopt;
    return length;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> MessageReader::next() {
  constexpr std::size_t longestHeader = 4096;
  if (broken_) return std::nullopt;
  const std::size_t end = std::string_view(buffer_).substr(0, longestHeader).find("\r\n\r\n");
  if (end == std::string::npos) {
    broken_ = buffer_.size() >= longestHeader;
    return std::nullopt;
  }
  const std::optional<std::size_t> length = lengthOf(std::string_view(buffer_).substr(0, end + 2));
  broken_ = !length || *length > largestMessage;
  if (broken_ || buffer_.size() - (end + 4) < *length) return std::nullopt;
  std::string message = buffer_.substr(end + 4, *length);
  buffer_.erase(0, end + 4 + *length);
  return message;
}

}  // namespace xabsl::server
