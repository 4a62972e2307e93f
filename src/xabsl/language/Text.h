#pragma once

#include <string_view>

namespace xabsl {

// Not <cctype>: these do not depend on the locale and take any char.

constexpr bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether a name of XABSL may contain a character behind its first letter.
constexpr bool isNamePart(char c) {
  return isLetter(c) || isDigit(c) || c == '_' || c == '.';
}

constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

/// A text without the byte-order mark that some programs write before it.
constexpr std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

/// A text without the blanks around it.
constexpr std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  return text;
}

/// Removes the owner from `owner.name`; any other name is unchanged.
constexpr std::string_view withoutOwner(std::string_view name, std::string_view owner) {
  const bool owned = !owner.empty() && name.size() > owner.size() && name.starts_with(owner) &&
                     name[owner.size()] == '.';
  return owned ? name.substr(owner.size() + 1) : name;
}

}  // namespace xabsl
