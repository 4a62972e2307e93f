#pragma once
#include <elf.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace gt {

/// Bytes as hexadecimal digits, two each.
inline std::string hexDigits(std::string_view bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    text += digits[static_cast<unsigned char>(c) >> 4];
    text += digits[static_cast<unsigned char>(c) & 15];
  }
  return text;
}

/// A number as hexadecimal digits, as 0x1f.
inline std::string hexText(std::uint64_t number) {
  std::string digits;
  do digits.insert(digits.begin(), "0123456789abcdef"[number & 15]);
  while ((number >>= 4) > 0);
  return "0x" + digits;
}

/// The build id among the notes of a program in memory, in hexadecimal digits; empty if it has
/// none. Safe on any input.
inline std::string buildIdOf(std::string_view notes) {
  while (notes.size() >= sizeof(Elf64_Nhdr)) {
    Elf64_Nhdr note;
    std::memcpy(&note, notes.data(), sizeof note);
    const std::size_t nameSize = (std::size_t{note.n_namesz} + 3) / 4 * 4;
    const std::size_t size = sizeof note + nameSize + (std::size_t{note.n_descsz} + 3) / 4 * 4;
    if (size > notes.size()) break;
    if (note.n_type == NT_GNU_BUILD_ID && notes.substr(sizeof note).starts_with("GNU"))
      return hexDigits(notes.substr(sizeof note + nameSize, note.n_descsz));
    notes.remove_prefix(size);
  }
  return {};
}

}  // namespace gt
