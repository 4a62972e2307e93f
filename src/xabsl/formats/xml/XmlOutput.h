#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace xabsl::xml {

/// Text as it may stand in an attribute or an element.
std::string escaped(std::string_view text);

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

/// Writes elements and comments, each on a line of its own, indented by what is open.
class XmlOutput {
 public:
  void open(std::string_view element, const Attributes& attributes = {});
  void close(std::string_view element);
  void empty(std::string_view element, const Attributes& attributes = {});
  /// Two hyphens would end a comment; they are parted.
  void comment(std::string_view text);
  /// As it is.
  void line(std::string_view text);
  /// All that was written; then nothing is.
  std::string take() { return std::exchange(text_, {}); }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace xabsl::xml
