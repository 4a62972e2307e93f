#include "simulation/scene/Xml.h"

#include <libxml/parser.h>
#include <libxml/xmlerror.h>

#include <algorithm>
#include <filesystem>

namespace gt {
namespace {

struct ContextDeleter {
  void operator()(xmlParserCtxt* context) const { xmlFreeParserCtxt(context); }
};

std::string text(const xmlChar* s) {
  return s ? reinterpret_cast<const char*>(s) : "";
}

/// The node behind a node in the order in which they stand in the file, if it is an element or a
/// text that is not blank.
const xmlNode* following(const xmlNode* node) {
  const auto known = [](const xmlNode* n) {
    return n->type == XML_ELEMENT_NODE ||
           ((n->type == XML_TEXT_NODE || n->type == XML_CDATA_SECTION_NODE) &&
            !xmlIsBlankNode(const_cast<xmlNode*>(n)));
  };
  do {
    if (node->type == XML_ELEMENT_NODE && node->children) {
      node = node->children;
    } else {
      while (node && !node->next)
        node = node->parent && node->parent->type == XML_ELEMENT_NODE ? node->parent : nullptr;
      if (node) node = node->next;
    }
  } while (node && !known(node));
  return node;
}

/// Scans the text of an XML file and returns the places at which nodes begin.
class XmlScan {
 public:
  explicit XmlScan(std::string_view text) : text_{text} {}

  FilePlace place() const { return {line_, column_}; }
  bool ended() const { return at_ >= text_.size(); }
  bool sees(std::string_view begin) const { return text_.substr(at_).starts_with(begin); }
  /// Advances by a number of bytes.
  void skip(std::size_t bytes) {
    const std::size_t end = std::min(text_.size(), at_ + bytes);
    for (; at_ < end; ++at_) {
      const auto c = static_cast<unsigned char>(text_[at_]);
      if (c == '\n') {
        ++line_;
        column_ = 1;
      } else if ((c & 0xc0) != 0x80) {  // a character of UTF-8 may have several bytes
        ++column_;
      }
    }
  }
  /// Advances behind the next occurrence of a text.
  void skipBehind(std::string_view end) {
    const std::size_t found = text_.find(end, at_);
    skip(found == text_.npos ? text_.npos - at_ : found + end.size() - at_);
  }
  void skipBlanks() { take(" \t\r\n", true); }
  std::string takeUntil(std::string_view ends) { return take(ends, false); }

 private:
  std::string take(std::string_view letters, bool are) {
    const std::size_t end = std::min(text_.size(), are ? text_.find_first_not_of(letters, at_)
                                                       : text_.find_first_of(letters, at_));
    std::string taken{text_.substr(at_, end - at_)};
    skip(end - at_);
    return taken;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
};

}  // namespace

Result<XmlDocument> readXml(const std::string& path, const std::string& root) {
  std::error_code code;
  if (!std::filesystem::is_regular_file(path, code))
    return Error{.file = path,
                 .what = std::filesystem::is_directory(path, code) ? "is a folder"
                                                                   : "there is no such file"};
  const std::unique_ptr<xmlParserCtxt, ContextDeleter> context{xmlNewParserCtxt()};
  context->sax->serror = [](void*, xmlError*) {};
  XmlDocument document{
      xmlCtxtReadFile(context.get(), path.c_str(), nullptr, XML_PARSE_NONET | XML_PARSE_NOBLANKS)};
  if (!document) {
    std::string what = text(reinterpret_cast<const xmlChar*>(context->lastError.message));
    what = what.substr(0, what.find('\n'));  // the rest shows bytes of the file
    return errorAt(path, {context->lastError.line, context->lastError.int2}, "",
                   what.empty() ? "is not XML" : what);
  }
  const xmlNode* node = xmlDocGetRootElement(document.get());
  if (!node || (!root.empty() && nameOf(node) != root))
    return Error{.file = path,
                 .line = node ? lineOf(node) : 0,
                 .field = node ? nameOf(node) : "",
                 .what = "expected the root element <" + root + ">"};
  return document;
}

XmlDocument parseXml(const std::string& text) {
  const std::unique_ptr<xmlParserCtxt, ContextDeleter> context{xmlNewParserCtxt()};
  context->sax->serror = [](void*, xmlError*) {};
  return XmlDocument{xmlCtxtReadMemory(context.get(), text.data(), static_cast<int>(text.size()),
                                       nullptr, nullptr, XML_PARSE_NONET | XML_PARSE_NOBLANKS)};
}

std::string xmlText(const xmlDoc& document) {
  xmlChar* text = nullptr;
  int size = 0;
  xmlDocDumpFormatMemory(const_cast<xmlDoc*>(&document), &text, &size, 1);
  std::string result{reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
  xmlFree(text);
  return result;
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

void setAttribute(xmlNode* node, const char* name, const std::string& value) {
  xmlSetProp(node, BAD_CAST name, BAD_CAST value.c_str());
}

int lineOf(const xmlNode* node) {
  return static_cast<int>(xmlGetLineNo(const_cast<xmlNode*>(node)));
}

std::vector<xmlNode*> elementsOf(const xmlNode* parent) {
  std::vector<xmlNode*> found;
  for (xmlNode* child = parent->children; child; child = child->next)
    if (child->type == XML_ELEMENT_NODE) found.push_back(child);
  return found;
}

XmlPlaces::XmlPlaces(const xmlDoc& document, std::string_view text) {
  XmlScan scan{text};
  const xmlNode* node = xmlDocGetRootElement(const_cast<xmlDoc*>(&document));
  while (node && !scan.ended()) {
    scan.skipBlanks();
    const FilePlace place = scan.place();
    const bool markup = scan.sees("<"), data = scan.sees("<![CDATA[");
    if (markup && !data && (scan.sees("<!") || scan.sees("<?") || scan.sees("</"))) {
      scan.skipBehind(scan.sees("<!--") ? "-->" : scan.sees("<?") ? "?>" : ">");
      continue;
    }
    if (scan.ended()) return;
    if ((node->type == XML_ELEMENT_NODE) != (markup && !data)) return;  // not this file
    places_[{node, ""}] = place;
    if (data) {
      scan.skipBehind("]]>");
    } else if (!markup) {
      scan.takeUntil("<");
    } else {
      scan.skip(1);
      if (scan.takeUntil(" \t\r\n/>") != nameOf(node)) return;
      for (scan.skipBlanks(); !scan.ended() && !scan.sees(">") && !scan.sees("/");
           scan.skipBlanks()) {
        const FilePlace begin = scan.place();
        places_[{node, scan.takeUntil(" \t\r\n=")}] = begin;
        scan.takeUntil("\"'");
        const std::string_view quote = scan.sees("'") ? "'" : "\"";
        scan.skip(1);
        scan.skipBehind(quote);
      }
      scan.skipBehind(">");
    }
    node = following(node);
  }
}

FilePlace XmlPlaces::of(const xmlNode* node, const std::string& attribute) const {
  for (const std::string& name : {attribute, std::string{}})
    if (const auto found = places_.find({node, name}); found != places_.end()) return found->second;
  return {lineOf(node), 0};
}

}  // namespace gt
