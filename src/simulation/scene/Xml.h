#pragma once
#include <libxml/tree.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "simulation/scene/FilePlace.h"

namespace gt {

/// Frees an XML document.
struct XmlDocumentDeleter {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
using XmlDocument = std::unique_ptr<xmlDoc, XmlDocumentDeleter>;

/// Reads an XML file whose root element bears a name. Nothing is fetched from the net, entities are
/// not expanded.
Result<XmlDocument> readXml(const std::string& path, const std::string& root);

/// The name of an element, or of an attribute.
std::string nameOf(const xmlNode* node);

/// The value of an attribute; empty where there is none.
std::string attribute(const xmlNode* node, const char* name);

/// Sets an attribute's value.
void setAttribute(xmlNode* node, const char* name, const std::string& value);

/// An element's line in its file.
int lineOf(const xmlNode* node);

/// Where the elements, attributes and texts of a document begin: libxml2 reports lines only.
class XmlPlaces {
 public:
  /// The document was read from a file of this text.
  XmlPlaces(const xmlDoc& document, std::string_view text);

  FilePlace of(const xmlNode* node, const std::string& attribute = "") const;

 private:
  std::map<std::pair<const xmlNode*, std::string>, FilePlace> places_;
};

}  // namespace gt
