#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace xabsl {

/// Whether a byte of UTF-8 continues a character that began before it.
constexpr bool continuesLetter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/// The number of bytes of the first character of a text; 0 if it is not valid UTF-8.
std::size_t letterLength(std::string_view text);

/// Converts a text to UTF-8. Bytes that are not valid UTF-8 are read as Latin-1, which older teams
/// used.
std::string toUtf8(std::string text);

}  // namespace xabsl
