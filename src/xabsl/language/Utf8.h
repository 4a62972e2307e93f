#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace xabsl {

/// Whether a byte of UTF-8 continues a letter that began before it.
constexpr bool continuesLetter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/// The number of bytes of the letter that a text begins with; 0 if it is not valid UTF-8.
std::size_t letterLength(std::string_view text);

/// Texts of older teams are in Latin-1: bytes that are not valid UTF-8 are taken for that.
std::string toUtf8(std::string text);

}  // namespace xabsl
