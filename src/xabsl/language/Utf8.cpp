#include "xabsl/language/Utf8.h"

#include <algorithm>

namespace xabsl {

std::size_t letterLength(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned char first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!continuesLetter(text[i])) return 0;
  const unsigned char second = static_cast<unsigned char>(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool outside = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return overlong || outside ? 0 : length;
}

std::string toUtf8(std::string text) {
  std::string_view rest = text;
  while (letterLength(rest) > 0) rest.remove_prefix(letterLength(rest));
  if (rest.empty()) return text;
  std::string result(text, 0, text.size() - rest.size());
  while (!rest.empty()) {
    const std::size_t length = letterLength(rest);
    if (length > 0) {
      result += rest.substr(0, length);
    } else {
      const unsigned letter = static_cast<unsigned char>(rest.front());
      result += static_cast<char>(0xC0u | letter >> 6);
      result += static_cast<char>(0x80u | (letter & 0x3Fu));
    }
    rest.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace xabsl
