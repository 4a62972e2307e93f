#pragma once
#include <libxml/tree.h>

#include <memory>
#include <string>

#include "base/Result.h"

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

/// An element's line in its file.
int lineOf(const xmlNode* node);

}  // namespace gt
