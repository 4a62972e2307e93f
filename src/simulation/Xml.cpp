#include "simulation/Xml.h"

#include <libxml/parser.h>
#include <libxml/xmlerror.h>

#include <filesystem>

namespace gt {
namespace {

struct ContextDeleter {
  void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
};

std::string text(const xmlChar* s) {
  return s ? reinterpret_cast<const char*>(s) : "";
}

}  // namespace

Result<XmlDocument> readXml(const std::string& path, const std::string& root) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    return Error{path, 0, "", "there is no such file"};
  const std::unique_ptr<xmlParserCtxt, ContextDeleter> context{xmlNewParserCtxt()};
  context->sax->serror = [](void*, xmlError*) {};
  XmlDocument document{
      xmlCtxtReadFile(context.get(), path.c_str(), nullptr, XML_PARSE_NONET | XML_PARSE_NOBLANKS)};
  if (!document) {
    std::string what = text(reinterpret_cast<const xmlChar*>(context->lastError.message));
    what = what.substr(0, what.find('\n'));  // the rest shows bytes of the file
    return Error{path, context->lastError.line, "", what.empty() ? "is not XML" : what};
  }
  const xmlNode* node = xmlDocGetRootElement(document.get());
  if (!node || nameOf(node) != root)
    return Error{path, node ? lineOf(node) : 0, node ? nameOf(node) : "",
                 "expected the root element <" + root + ">"};
  return document;
}

std::string nameOf(const xmlNode* node) {
  return text(node->name);
}

std::string attribute(const xmlNode* node, const char* name) {
  xmlChar* value = xmlGetNoNsProp(const_cast<xmlNode*>(node), BAD_CAST name);
  std::string result = text(value);
  xmlFree(value);
  return result;
}

int lineOf(const xmlNode* node) {
  return static_cast<int>(xmlGetLineNo(const_cast<xmlNode*>(node)));
}

}  // namespace gt
