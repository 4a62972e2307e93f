#include "xabsl/formats/xml/XmlOutput.h"

namespace xabsl::xml {
namespace {

std::string tag(std::string_view element, const Attributes& attributes) {
  std::string text = "<" + std::string(element);
  for (const auto& [key, value] : attributes)
    text += " " + std::string(key) + "=\"" + escaped(value) + "\"";
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c == '\n' || c == '\t')
      result += c == '\n' ? "&#10;" : "&#9;";
    else if (c != '\r')
      result += c;
  }
  return result;
}

void XmlOutput::open(std::string_view element, const Attributes& attributes) {
  line(tag(element, attributes) + ">");
  ++depth_;
}

void XmlOutput::close(std::string_view element) {
  --depth_;
  line("</" + std::string(element) + ">");
}

void XmlOutput::empty(std::string_view element, const Attributes& attributes) {
  line(tag(element, attributes) + "/>");
}

void XmlOutput::comment(std::string_view source) {
  std::string text(source);
  for (std::size_t i = text.find("--"); i != std::string::npos; i = text.find("--"))
    text.replace(i, 2, "- -");
  if (!text.empty() && text.back() == '-') text += ' ';
  line("<!-- " + text + " -->");
}

void XmlOutput::line(std::string_view text) {
  text_ += std::string(2 * depth_, ' ') + std::string(text) + "\n";
}

}  // namespace xabsl::xml
