#include "xabsl/tools/server/XmlScan.h"

#include <algorithm>

#include "xabsl/language/Language.h"
#include "xabsl/language/Text.h"

namespace xabsl::server {

namespace {

constexpr std::size_t mostScannedElements = 300'000;
constexpr std::size_t deepestElement = 400;  // what is below has no entry of its own

/// The rank of an element of XABSL by its nesting: an element ends open ones of its own and of
/// higher rank. 0: anywhere.
int rankOf(std::string_view name) {
  if (name == "option") return 1;
  if (name == "symbols" || name == "basic-behaviors" || name == "option-definitions" ||
      name == "agent" || name == "state")
    return 2;
  if (name == "enumeration" || name == "constant" || name == "basic-behavior" ||
      name == "option-definition" || name == "decimal-input-function" ||
      (name.ends_with("-symbol") && !name.starts_with("set-")))
    return 3;
  return 0;
}

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  XmlScan run() {
    for (std::size_t i = find('<', 0); i < text_.size(); i = find('<', i)) i = tag(i);
    while (!open_.empty()) closeLast(text_.size());
    return std::move(scan_);
  }

 private:
  std::size_t find(char letter, std::size_t from) const {
    return std::min(text_.find(letter, from), text_.size());
  }
  bool isAt(std::size_t i, std::string_view expected) const {
    return text_.substr(i, expected.size()) == expected;
  }

  /// Takes what begins with a '<'; returns where to go on.
  std::size_t tag(std::size_t begin) {
    if (isAt(begin, "<!--")) {
      const std::size_t end = behind("-->", begin);
      scan_.comments.push_back({begin, end});
      return end;
    }
    if (isAt(begin, "<![CDATA[")) return behind("]]>", begin);
    if (isAt(begin, "</")) return endTag(begin);
    const std::string_view name = nameAt(begin + 1);
    return name.empty() ? begin + 1 : startTag(begin, name);
  }

  /// Behind an end; what has none is over with its line.
  std::size_t behind(std::string_view end, std::size_t from) const {
    const std::size_t found = text_.find(end, from);
    return found == std::string_view::npos ? find('\n', from) : found + end.size();
  }

  std::string_view nameAt(std::size_t begin) const {
    const std::size_t end =
        std::min(text_.find_first_of(" \t\r\n\f<>/=\"'!?", begin), text_.size());
    return text_.substr(begin, end - begin);
  }
  static std::string_view withoutPrefix(std::string_view name) {
    return name.substr(name.rfind(':') + 1);
  }

  std::size_t startTag(std::size_t begin, std::string_view whole) {
    ScannedElement element;
    element.name = withoutPrefix(whole);
    element.begin = begin;
    std::size_t i = begin + 1 + whole.size();
    element.labelAt = i;
    std::string_view attribute;
    while (i < text_.size() && text_[i] != '>' && text_[i] != '<') {
      if (text_[i] == '"' || text_[i] == '\'') {
        // No '<' stands in a value: then the quote at its end is missing.
        const std::size_t last = std::min(find(text_[i], i + 1), find('<', i + 1));
        if ((attribute == "name" || attribute == "id") && element.label.empty()) {
          const std::string_view value = text_.substr(i + 1, last - i - 1);
          element.label = trimmed(value.substr(0, value.find_first_of("\n>")));
          element.labelAt = element.label.empty()
                                ? i + 1
                                : static_cast<std::size_t>(element.label.data() - text_.data());
        }
        attribute = {};
        i = last < text_.size() && text_[last] != '<' ? last + 1 : last;
      } else if (const std::string_view word = nameAt(i); !word.empty()) {
        attribute = word;
        i += word.size();
      } else {
        ++i;
      }
    }
    const bool closed = i < text_.size() && text_[i] == '>';
    const bool isEmpty = closed && text_[i - 1] == '/';
    if (closed) ++i;
    element.end = i;
    add(element, isEmpty);
    return i;
  }

  void add(ScannedElement& element, bool isEmpty) {
    if (const int rank = rankOf(element.name); rank > 0) endFrom(rank, element.begin);
    if (scan_.elements.size() >= mostScannedElements || open_.size() >= deepestElement) return;
    element.parent = open_.empty() ? -1 : open_.back();
    scan_.elements.push_back(element);
    if (!isEmpty) open_.push_back(static_cast<int>(scan_.elements.size()) - 1);
  }

  /// Ends the outermost open element of a rank or a higher one, with all in it.
  void endFrom(int rank, std::size_t place) {
    const auto outermost = std::ranges::find_if(
        open_, [&](int index) { return rankOf(scan_.elements[at(index)].name) >= rank; });
    const auto rest = static_cast<std::size_t>(outermost - open_.begin());
    while (open_.size() > rest) closeLast(place);
  }

  std::size_t endTag(std::size_t begin) {
    const std::string_view name = nameAt(begin + 2);
    std::size_t end = begin + 2 + name.size();
    const std::size_t close = text_.find_first_of("<>", end);
    if (close != std::string_view::npos && text_[close] == '>') end = close + 1;
    const auto same = std::find_if(open_.rbegin(), open_.rend(), [&](int index) {
      return scan_.elements[at(index)].name == withoutPrefix(name);
    });
    if (same == open_.rend()) return end;
    const auto rest = static_cast<std::size_t>(open_.rend() - same);
    while (open_.size() > rest) closeLast(begin);
    scan_.elements[at(open_.back())].end = end;
    open_.pop_back();
    return end;
  }

  /// Without an end tag, before what stands there.
  void closeLast(std::size_t place) {
    ScannedElement& element = scan_.elements[at(open_.back())];
    while (place > element.end && isBlank(text_[place - 1])) --place;
    element.end = std::max(element.end, place);
    open_.pop_back();
  }

  static std::size_t index_(int index) { return static_cast<std::size_t>(index); }

  std::string_view text_;
  XmlScan scan_;
  std::vector<int> open_;  ///< indices of elements
};

}  // namespace

XmlScan scanXml(std::string_view text) {
  return Scanner(text).run();
}

}  // namespace xabsl::server
