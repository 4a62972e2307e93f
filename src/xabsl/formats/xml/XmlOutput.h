#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace xabsl::xml {

/// Text escaped for an attribute or an element.
std::string escaped(std::string_view text);

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

/// Writes elements and comments, each on a separate line, indented by the nesting depth.
class XmlOutput {
 public:
  void open(std::string_view element, const Attributes& attributes = {});
  void close(std::string_view element);
  void empty(std::string_view element, const Attributes& attributes = {});
  /// Writes a comment. Double hyphens, which would end it, are separated.
  void comment(std::string_view text);
  /// Writes a line unchanged.
  void line(std::string_view text);
  /// Returns the text written so far and clears it.
  std::string take() { return std::exchange(text_, {}); }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace xabsl::xml
