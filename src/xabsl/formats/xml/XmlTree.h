#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Language.h"

/// The XML trees of a behavior's files, before their meaning is analyzed. All texts are views into
/// the pool of the program.
namespace xabsl::xml {

constexpr std::string_view namespace21 = "http://www.ki.informatik.hu-berlin.de/XABSL2.1";
/// Namespace of the form into which the public compilers of XABSL 3 translate text.
constexpr std::string_view namespace31 = "http://www.xabsl.de";

constexpr std::string_view namespaceOf(Dialect dialect) {
  return dialect == Dialect::xabsl21 ? namespace21 : namespace31;
}

struct Attribute {
  std::string_view name;
  std::string_view value;
  Location location;  ///< of the value
};

/// An element, a comment, or the place where another file is included.
struct Element {
  enum class Kind { element, comment, entity, include };

  Kind kind = Kind::element;
  std::string_view name;
  std::string_view text;     ///< text of an element or a comment; file that an inclusion names
  std::string_view doctype;  ///< of an entity: the file that declares it, if it is another one
  Location location;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  int file = -1;  ///< the included file, an index into Files; -1: it cannot be read

  bool is(std::string_view expected) const { return kind == Kind::element && name == expected; }

  /// The value of an attribute; empty where there is none.
  std::string_view attribute(std::string_view key) const {
    const Attribute* found = find(key);
    return found ? found->value : std::string_view();
  }
  const Attribute* find(std::string_view key) const {
    for (const Attribute& candidate : attributes)
      if (candidate.name == key) return &candidate;
    return nullptr;
  }
};

/// One file. An external entity may have several root elements.
struct File {
  std::string path;
  std::vector<Element> roots;
  Dialect dialect = Dialect::xabsl21;  ///< by the namespace of its elements
};

/// All files of a behavior. The first one is the file with the agents. No file includes itself.
using Files = std::vector<File>;

/// The kinds of inclusions that are followed: external entities are a part of their file, XInclude
/// joins files.
enum class Follow { entities, everything };

/// Calls `visit` for each element and comment of a list, those of included files in their place.
template <typename Visit>
void forEach(const Files& files, const std::vector<Element>& elements, Follow follow,
             const Visit& visit) {
  for (const Element& element : elements) {
    const bool entered = element.kind == Element::Kind::entity ||
                         (element.kind == Element::Kind::include && follow == Follow::everything);
    if (!entered)
      visit(element);
    else if (element.file >= 0)
      forEach(files, files[at(element.file)].roots, follow, visit);
  }
}

}  // namespace xabsl::xml
