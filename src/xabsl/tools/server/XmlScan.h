#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace xabsl::server {

/// An element of XML. Places are bytes of the text.
struct ScannedElement {
  std::string_view name;   ///< without a prefix
  std::string_view label;  ///< attribute `name` or `id`; empty: none yet
  std::size_t begin = 0;
  /// behind its end tag, or where the next element shows that it has ended
  std::size_t end = 0;
  std::size_t labelAt = 0;  ///< place of the label; without a label, of the tag's end
  int parent = -1;          ///< index of the element around it, or -1
};

/// The result of scanning the tags of a text.
struct XmlScan {
  struct Part {
    std::size_t begin = 0, end = 0;
  };

  std::vector<ScannedElement> elements;  ///< in the order of their tags
  std::vector<Part> comments;
};

/// Finds elements and comments of a behavior in XML while it is being typed: a missing tag, end or
/// quote affects only its own place. Safe for any text.
XmlScan scanXml(std::string_view text);

}  // namespace xabsl::server
