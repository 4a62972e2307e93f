#include "xabsl/tools/server/Uri.h"

#include <filesystem>
#include <string_view>

namespace xabsl::server {

namespace {

/// Removes a prefix from a text, without regard to case.
bool take(std::string_view& text, std::string_view prefix) {
  if (text.size() < prefix.size()) return false;
  for (std::size_t i = 0; i < prefix.size(); ++i)
    if ((prefix[i] >= 'a' && prefix[i] <= 'z' ? text[i] | 0x20 : text[i]) != prefix[i])
      return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// The normalized path, which is the same for all spellings of a place.
std::string normal(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().generic_string();
}

}  // namespace

std::string pathOf(const std::string& uri) {
  std::string_view rest = uri;  // file:/path, file:///path or file://localhost/path (RFC 8089)
  if (!take(rest, "file:")) return normal(uri);
  if (take(rest, "//")) take(rest, "localhost");
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'                     ? c - '0'
           : (c | 0x20) >= 'a' && (c | 0x20) <= 'f' ? (c | 0x20) - 'a' + 10
                                                    : -1;
  };
  std::string path;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const bool coded =
        rest[i] == '%' && i + 2 < rest.size() && digit(rest[i + 1]) >= 0 && digit(rest[i + 2]) >= 0;
    path += coded ? static_cast<char>(digit(rest[i + 1]) * 16 + digit(rest[i + 2])) : rest[i];
    if (coded) i += 2;
  }
  return normal(path);
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
