#include "xabsl/formats/xml/XmlReader.h"

#include <libxml/encoding.h>
#include <libxml/parser.h>
#include <libxml/parserInternals.h>

#include <algorithm>
#include <memory>

#include "xabsl/formats/xml/XmlDocument.h"
#include "xabsl/language/Text.h"
#include "xabsl/language/Utf8.h"

namespace xabsl::xml {

namespace {

constexpr std::size_t mostElementsInFile = 300'000;  // of one file; each costs memory
constexpr std::size_t longestTag = 16u << 10;  // libxml2 compares each attribute with all others
constexpr std::string_view includeNamespaces[] = {"http://www.w3.org/2001/XInclude",
                                                  "http://www.w3.org/2003/XInclude"};

struct ParserDeleter {
  void operator()(xmlParserCtxt* parser) const { xmlFreeParserCtxt(parser); }
};
struct StringDeleter {
  void operator()(xmlChar* text) const { xmlFree(text); }
};
struct BufferDeleter {
  void operator()(xmlBuffer* buffer) const { xmlBufferFree(buffer); }
};

std::string_view view(const xmlChar* text) {
  return text ? reinterpret_cast<const char*>(text) : std::string_view();
}

/// A readable message in place of libxml2's internal ones.
std::string readable(const xmlError& error) {
  if (error.code == XML_ERR_NAME_REQUIRED || error.code == XML_ERR_ENTITYREF_SEMICOL_MISSING)
    return "'&' begins the name of an entity, which ends with ';'; for the letter write '&amp;'";
  if (error.code == XML_ERR_LT_IN_ATTRIBUTE) return "'<' in a value must be written as '&lt;'";
  std::string message = error.message ? error.message : "this is no well-formed XML";
  while (!message.empty() && (message.back() == '\n' || message.back() == '.')) message.pop_back();
  return message;
}

/// Lines and columns of places in a text.
class Lines {
 public:
  Lines(int file, std::string_view text) : file_(file), text_(text) {
    starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n') starts_.push_back(i + 1);
  }

  Location place(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
    // A file may be one line: what was counted for the last place is not counted again.
    if (last_ > offset || last_ < *(next - 1)) {
      last_ = *(next - 1);
      letters_ = 0;
    }
    // Columns count letters, not bytes.
    for (; last_ < offset; ++last_) letters_ += !continuesLetter(text_[last_]);
    return {file_, static_cast<int>(next - starts_.begin()), letters_ + 1};
  }

 private:
  int file_;
  std::string_view text_;
  std::vector<std::size_t> starts_;
  mutable std::size_t last_ = 0;  // the place that was asked for last
  mutable int letters_ = 0;       // before it in its line
};

/// Reads one file with libxml2 and converts its tree to ours.
class Reader {
 public:
  Reader(int file, std::string_view text, Reporter& reporter, syntax::Program& program)
      : file_(file), text_(text), lines_(file, text), reporter_(reporter), program_(program) {}

  void read(File& file) {
    checkTags();
    if (reported_) return;
    const std::unique_ptr<xmlParserCtxt, ParserDeleter> parser(xmlNewParserCtxt());
    if (!parser) return;
    parser_ = parser.get();
    parser_->_private = this;
    parser_->sax->startElementNs = startElement;
    parser_->sax->serror = [](void* context, auto* error) { problem(context, *error); };
    // Entities are not replaced: so external ones are never read by libxml2 itself.
    constexpr int options = XML_PARSE_NONET | XML_PARSE_NOCDATA | XML_PARSE_BIG_LINES;
    const Document document(xmlCtxtReadMemory(parser_, text_.data(), static_cast<int>(text_.size()),
                                              nullptr, "UTF-8", options));
    if (!document) {
      if (!reported_) reporter_.error({file_, 1, 1}, "this is no well-formed XML");
    } else if (!reported_) {
      Element all;
      children(document->children, all, {file_, 1, 1}, 0);
      file.roots = std::move(all.children);
      if (space_ == namespace31) file.dialect = Dialect::xabsl31;
    }
  }

 private:
  void checkTags() {
    std::size_t end = 0;
    for (std::size_t i = text_.find('<'); i != std::string_view::npos; i = text_.find('<', end)) {
      end = std::min(text_.find('>', i), text_.size());
      if (text_.substr(i, 2) != "<!" && end - i > longestTag)
        return fail(lines_.place(i), "the tag is longer than 16 KiB");
    }
  }

  /// Notes where each start tag begins; libxml2 itself only knows the line where it ends.
  static void startElement(void* context, const xmlChar* name, const xmlChar* prefix,
                           const xmlChar* uri, int namespaceCount, const xmlChar** namespaces,
                           int attributeCount, int defaulted, const xmlChar** attributes) {
    xmlSAX2StartElementNs(context, name, prefix, uri, namespaceCount, namespaces, attributeCount,
                          defaulted, attributes);
    auto* parser = static_cast<xmlParserCtxt*>(context);
    const auto* reader = static_cast<const Reader*>(parser->_private);
    // What stands in an internal entity has no place of its own.
    if (parser != reader->parser_ || !parser->node || parser->inputNr != 1) return;
    const xmlParserInput& input = *parser->input;
    const std::size_t end = input.consumed + static_cast<std::size_t>(input.cur - input.base);
    const std::size_t begin = reader->text_.rfind('<', end);
    if (begin != std::string_view::npos)
      parser->node->_private = const_cast<char*>(reader->text_.data() + begin);
  }

  static void problem(void* context, const xmlError& error) {
    auto* parser = static_cast<xmlParserCtxt*>(context);
    // An entity may be declared in a file that is not read here.
    if (error.level < XML_ERR_ERROR || error.code == XML_WAR_UNDECLARED_ENTITY) return;
    Reader& reader = *static_cast<Reader*>(parser->_private);
    const std::string message = readable(error);
    const bool own = parser == reader.parser_ && parser->inputNr <= 1;
    const Location location =
        own ? Location{reader.file_, std::max(error.line, 1), std::max(error.int2, 1)}
            : Location{reader.file_, 1, 1};
    // One slip makes many errors behind it.
    if (!reader.reported_) reader.reporter_.error(location, message);
    reader.reported_ = true;
    // Some errors quote all that was read before: thousands of them would take hours.
    xmlStopParser(parser);
  }

  void children(const xmlNode* first, Element& parent, Location place, int depth) {
    constexpr int deepest = 300;
    for (const xmlNode* node = first; node && !reported_; node = node->next) {
      if (node->type == XML_DTD_NODE || node->type == XML_PI_NODE) continue;
      if (depth > deepest) return fail(place, "nested too deeply");
      if (++count_ > mostElementsInFile) return fail(place, "the file has too many elements");
      if (node->type == XML_ELEMENT_NODE) {
        element(*node, parent, place, depth);
      } else if (node->type == XML_ENTITY_REF_NODE) {
        reference(*node, parent, place);
      } else if (node->type == XML_COMMENT_NODE) {
        Element comment;
        comment.kind = Element::Kind::comment;
        comment.text = keep(trimmed(view(node->content)));
        comment.location = place;
        parent.children.push_back(std::move(comment));
      } else if (node->type == XML_TEXT_NODE && !trimmed(view(node->content)).empty()) {
        parent.text =
            parent.text.empty()
                ? keep(trimmed(view(node->content)))
                : keep(std::string(parent.text) + " " + std::string(trimmed(view(node->content))));
      }
      if (node->_private) place = lines_.place(offset(*node));
    }
  }

  void element(const xmlNode& node, Element& parent, Location place, int depth) {
    Element element;
    element.name = keep(view(node.name));
    element.location = node._private ? lines_.place(offset(node)) : place;
    for (const xmlAttr* attribute = node.properties; attribute; attribute = attribute->next)
      addAttribute(node, *attribute, element);
    if (isInclude(node)) {
      include(element);
    } else if (!isOfXabsl(node)) {
      return fail(element.location, "element '" + std::string(element.name) +
                                        "' is not of the namespace " +
                                        std::string(space_.empty() ? namespace21 : space_));
    } else {
      children(node.children, element, element.location, depth + 1);
    }
    parent.children.push_back(std::move(element));
  }

  /// The first element that has a namespace determines that of all others.
  bool isOfXabsl(const xmlNode& node) {
    if (!node.ns) return true;
    const std::string_view space = view(node.ns->href);
    if (space_.empty() && (space == namespace21 || space == namespace31))
      space_ = space == namespace21 ? namespace21 : namespace31;
    return space == space_;
  }

  static bool isInclude(const xmlNode& node) {
    const std::string_view space = node.ns ? view(node.ns->href) : std::string_view();
    if (space.empty() || space == namespace21) return view(node.name) == "xinclude";
    return std::find(std::begin(includeNamespaces), std::end(includeNamespaces), space) !=
               std::end(includeNamespaces) &&
           view(node.name) == "include";
  }

  /// XInclude, as far as behaviors need it: the whole of another XML file.
  void include(Element& element) {
    element.kind = Element::Kind::include;
    element.text = element.attribute("href");
    if (const Attribute* href = element.find("href")) element.location = href->location;
    if (element.text.empty()) fail(element.location, "expected the name of a file in 'href'");
    for (const Attribute& attribute : element.attributes)
      if (attribute.name != "href" && !(attribute.name == "parse" && attribute.value == "xml"))
        fail(attribute.location,
             inQuotes(attribute.name) + " is not supported; whole files are included");
  }

  void addAttribute(const xmlNode& node, const xmlAttr& attribute, Element& element) {
    const std::string_view space = attribute.ns ? view(attribute.ns->href) : std::string_view();
    // Where the schema lies and which file an element came from are not of the language.
    if (space == "http://www.w3.org/2001/XMLSchema-instance" ||
        space == "http://www.w3.org/XML/1998/namespace")
      return;
    for (const xmlNode* part = attribute.children; part; part = part->next)
      if (part->type == XML_ENTITY_REF_NODE)
        return fail(element.location,
                    "entity '" + std::string(view(part->name)) + "' in the value of an attribute");
    const std::unique_ptr<xmlChar, StringDeleter> value(
        xmlNodeListGetString(node.doc, attribute.children, 1));
    const Location location =
        node._private ? attributeLocation(offset(node), view(attribute.name)) : element.location;
    element.attributes.push_back(
        {keep(view(attribute.name)), keep(trimmed(view(value.get()))), location});
  }

  /// Where the value of an attribute stands in the tag that begins at an offset.
  Location attributeLocation(std::size_t tag, std::string_view name) const {
    std::size_t i = tag;
    while (i < text_.size() && !isBlank(text_[i]) && text_[i] != '>') ++i;
    while (i < text_.size() && text_[i] != '>') {
      while (i < text_.size() && isBlank(text_[i])) ++i;
      const std::size_t begin = i;
      while (i < text_.size() && !isBlank(text_[i]) && text_[i] != '=' && text_[i] != '>') ++i;
      std::string_view found = text_.substr(begin, i - begin);
      found = found.substr(found.find(':') + 1);
      const std::size_t quote = text_.find_first_of("\"'>", i);
      if (quote == std::string_view::npos || text_[quote] == '>') break;
      if (found == name) return lines_.place(quote + 1);
      i = text_.find(text_[quote], quote + 1);
      if (i == std::string_view::npos) break;
      ++i;
    }
    return lines_.place(tag);
  }

  /// `&name;` stands for an external file, or for what was declared inside of this one.
  void reference(const xmlNode& node, Element& parent, Location place) {
    const xmlEntity* entity = xmlGetDocEntity(node.doc, node.name);
    const xmlDtd* doctype = node.doc->intSubset;
    if (!entity && (!doctype || !doctype->SystemID))
      return fail(place, "entity '" + std::string(view(node.name)) + "' is not declared");
    // Texts that stand for texts grow without bounds, and behaviors do not need them.
    if (entity && entity->etype != XML_EXTERNAL_GENERAL_PARSED_ENTITY)
      return fail(place, "entity '" + std::string(view(node.name)) + "' names no file");
    Element inclusion;
    inclusion.kind = Element::Kind::entity;
    inclusion.name = keep(view(node.name));
    if (entity)
      inclusion.text = keep(view(entity->SystemID));
    else
      inclusion.doctype = keep(view(doctype->SystemID));
    inclusion.location = referenceLocation(inclusion.name, place);
    parent.children.push_back(std::move(inclusion));
  }

  Location referenceLocation(std::string_view name, Location place) const {
    const std::size_t found = text_.find("&" + std::string(name) + ";");
    return found == std::string_view::npos ? place : lines_.place(found);
  }

  void fail(Location location, const std::string& message) {
    reported_ = true;
    reporter_.error(location, message);
  }

  std::size_t offset(const xmlNode& node) const {
    return static_cast<std::size_t>(static_cast<const char*>(node._private) - text_.data());
  }

  std::string_view keep(std::string_view text) {
    return text.empty() ? std::string_view() : program_.keep(std::string(text));
  }

  int file_;
  std::string_view text_;
  Lines lines_;
  Reporter& reporter_;
  syntax::Program& program_;
  xmlParserCtxt* parser_ = nullptr;
  std::string_view space_;  // of the elements
  std::size_t count_ = 0;
  bool reported_ = false;
};

/// The encoding that an XML declaration names; empty: UTF-8.
std::string declaredEncoding(std::string_view text) {
  const std::string_view declaration = text.substr(0, text.find("?>"));
  const std::size_t found = declaration.find("encoding");
  if (declaration.substr(0, 5) != "<?xml" || found == std::string_view::npos) return {};
  const std::size_t open = declaration.find_first_of("\"'", found);
  if (open == std::string_view::npos) return {};
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return {};
  std::string name(declaration.substr(open + 1, close - open - 1));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
  return name == "UTF-8" || name == "UTF8" ? std::string() : name;
}

}  // namespace

bool isXml(std::string_view text) {
  return trimmed(withoutByteOrderMark(text)).starts_with('<');
}

bool toUtf8(std::string& text) {
  const std::string encoding = declaredEncoding(text);
  if (encoding.empty()) return true;
  xmlCharEncodingHandler* handler = xmlFindCharEncodingHandler(encoding.c_str());
  if (!handler) return false;
  const std::unique_ptr<xmlBuffer, BufferDeleter> in(
      xmlBufferCreateStatic(text.data(), text.size()));
  const std::unique_ptr<xmlBuffer, BufferDeleter> out(xmlBufferCreate());
  const bool converted = in && out && xmlCharEncInFunc(handler, out.get(), in.get()) >= 0;
  if (converted) text = view(xmlBufferContent(out.get()));
  xmlCharEncCloseFunc(handler);
  return converted;
}

void readElements(int index, std::string_view text, Reporter& reporter, syntax::Program& program,
                  File& file) {
  Reader(index, text, reporter, program).read(file);
}

std::map<std::string, std::string, std::less<>> readEntities(std::string_view text) {
  constexpr std::string_view begin = "<!ENTITY", comment = "<!--", commentEnd = "-->";
  std::map<std::string, std::string, std::less<>> entities;
  const auto word = [&text] {
    text = trimmed(text);
    const std::size_t end = std::min(text.find_first_of(" \t\r\n>\"'"), text.size());
    const std::string_view found = text.substr(0, end);
    text.remove_prefix(end);
    return found;
  };
  for (;;) {
    text.remove_prefix(std::min(text.find("<!"), text.size()));
    if (text.empty()) return entities;
    if (text.substr(0, comment.size()) == comment) {
      text.remove_prefix(std::min(text.find(commentEnd), text.size()));
      continue;
    }
    const bool entity = text.substr(0, begin.size()) == begin;
    text.remove_prefix(entity ? begin.size() : 2);
    if (!entity) continue;
    const std::string name(word());
    if (word() != "SYSTEM") continue;
    text = trimmed(text);
    if (text.empty() || (text.front() != '"' && text.front() != '\'')) continue;
    const std::size_t close = text.find(text.front(), 1);
    if (close == std::string_view::npos) return entities;
    entities.emplace(name, std::string(text.substr(1, close - 1)));
    text.remove_prefix(close + 1);
  }
}

}  // namespace xabsl::xml
