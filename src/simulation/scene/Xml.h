#pragma once
#include <libxml/tree.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulation/scene/FilePlace.h"

namespace gt {

/// Frees an XML document.
struct XmlDocumentDeleter {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
using XmlDocument = std::unique_ptr<xmlDoc, XmlDocumentDeleter>;

/// Reads an XML file. Fails if the root element has another name than `root`, unless `root` is
/// empty. Nothing is fetched from the net, entities are not expanded.
Result<XmlDocument> readXml(const std::string& path, const std::string& root);

/// Parses a text; null if it is no XML document.
XmlDocument parseXml(const std::string& text);

/// A document as text: each element without text begins a line.
std::string xmlText(const xmlDoc& document);

/// The name of an element, or of an attribute.
std::string nameOf(const xmlNode* node);

/// The value of an attribute; empty where there is none.
std::string attribute(const xmlNode* node, const char* name);

/// Sets an attribute's value.
void setAttribute(xmlNode* node, const char* name, const std::string& value);

/// An element's line in its file.
int lineOf(const xmlNode* node);

/// The child elements of an element.
std::vector<xmlNode*> elementsOf(const xmlNode* parent);

/// Calls visit(element) for an element and all below it, in the order of the file.
template <typename Node, typename Visit>
void forEachElement(Node* node, const Visit& visit) {
  if (node->type != XML_ELEMENT_NODE) return;
  visit(node);
  for (Node* child = node->children; child; child = child->next) forEachElement(child, visit);
}

/// The lines and columns at which the elements, attributes and texts of a document begin: libxml2
/// reports lines only.
class XmlPlaces {
 public:
  /// `text` is the content of the file from which the document was read.
  XmlPlaces(const xmlDoc& document, std::string_view text);

  FilePlace of(const xmlNode* node, const std::string& attribute = "") const;

 private:
  std::map<std::pair<const xmlNode*, std::string>, FilePlace> places_;
};

}  // namespace gt
