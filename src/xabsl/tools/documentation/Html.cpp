#include "xabsl/tools/documentation/Html.h"

#include <algorithm>
#include <array>

#include "xabsl/formats/XmlOutput.h"

namespace xabsl::documentation {

namespace {

unsigned char byteOf(char c) {
  return static_cast<unsigned char>(c);
}

/// How many bytes the letter at the beginning of a text has in UTF-8; 0: it is none.
std::size_t letterSize(std::string_view text) {
  const unsigned char first = byteOf(text[0]);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xC2 && first < 0xE0   ? 2
                           : first >= 0xE0 && first < 0xF0 ? 3
                           : first >= 0xF0 && first < 0xF5 ? 4
                                                           : 0;
  if (size == 0 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byteOf(text[i]) & 0xC0u) != 0x80u) return 0;
  const unsigned char second = byteOf(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool outside = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return overlong || outside ? 0 : size;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::string utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t size = letterSize(text);
    const unsigned char c = byteOf(text[0]);
    if (size == 0) {
      result += static_cast<char>(0xC0u | (c >> 6));
      result += static_cast<char>(0x80u | (c & 0x3Fu));
    } else if (size > 1 || (c >= ' ' && c != 0x7F) || c == '\n' || c == '\t') {
      result += text.substr(0, size);
    }
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return result;
}

std::string escaped(std::string_view text) {
  return xml::escaped(utf8(text));
}

std::string quotedScript(std::string_view text) {
  std::string result = "\"";
  for (const char c : utf8(text)) {
    if (c == '"' || c == '\\')
      result += std::string{'\\', c};
    else if (c == '<')
      result += "\\u003c";  // so that no text ends the script
    else
      result += c == '\n' || c == '\t' ? ' ' : c;
  }
  return result + '"';
}

std::string encoded(std::string_view name) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string result;
  for (const char c : name) {
    if (plain.find(c) != std::string_view::npos)
      result += c;
    else
      result += {'~', digits[byteOf(c) / 16], digits[byteOf(c) % 16]};
  }
  return result;
}

std::string plainDoc(std::string_view doc) {
  std::string result;
  while (!doc.empty()) {
    const std::size_t end = std::min(doc.find('\n'), doc.size());
    std::string_view line = trimmed(doc.substr(0, end));
    while (!line.empty() && line.front() == '*') line.remove_prefix(1);
    if (!result.empty()) result += '\n';
    result += trimmed(line);
    doc.remove_prefix(std::min(end + 1, doc.size()));
  }
  return std::string(trimmed(result));
}

std::string paragraphs(std::string_view doc) {
  const std::string plain = plainDoc(doc);
  std::string_view rest = plain;
  std::string result;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find("\n\n"), rest.size());
    const std::string_view paragraph = trimmed(rest.substr(0, end));
    if (!paragraph.empty()) result += "<p>" + escaped(paragraph) + "</p>\n";
    rest.remove_prefix(std::min(end + 2, rest.size()));
  }
  return result;
}

std::string firstSentence(std::string_view doc) {
  std::string plain = plainDoc(doc);
  plain = plain.substr(0, plain.find("\n\n"));
  std::replace(plain.begin(), plain.end(), '\n', ' ');
  const std::size_t end = plain.find(". ");
  return end == std::string::npos ? plain : plain.substr(0, end + 1);
}

}  // namespace xabsl::documentation
