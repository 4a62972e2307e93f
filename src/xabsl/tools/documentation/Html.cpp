#include "xabsl/tools/documentation/Html.h"

#include <algorithm>
#include <string>

#include "xabsl/formats/xml/XmlOutput.h"
#include "xabsl/language/Text.h"
#include "xabsl/language/Utf8.h"

namespace xabsl::documentation {

std::string utf8(std::string_view text) {
  std::string result = toUtf8(std::string(text));
  std::erase_if(result, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < ' ' && c != '\n' && c != '\t') || byte == 0x7F;
  });
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
      result += {'~', digits[static_cast<unsigned char>(c) / 16],
                 digits[static_cast<unsigned char>(c) % 16]};
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
