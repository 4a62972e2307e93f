#include "xabsl/formats/xml/XmlSchema.h"

#include <libxml/xmlschemas.h>

#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "xabsl/formats/xml/XmlDocument.h"
#include "xabsl/formats/xml/schema/SchemaFiles.h"

namespace xabsl::xml {

namespace {

struct SchemaDeleter {
  void operator()(xmlSchema* schema) const { xmlSchemaFree(schema); }
};
struct SchemaParserDeleter {
  void operator()(xmlSchemaParserCtxt* parser) const { xmlSchemaFreeParserCtxt(parser); }
};
struct ValidatorDeleter {
  void operator()(xmlSchemaValidCtxt* validator) const { xmlSchemaFreeValidCtxt(validator); }
};

const xmlChar* asXml(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

Document parse(std::string_view text) {
  return Document(
      xmlReadMemory(text.data(), static_cast<int>(text.size()), nullptr, nullptr, XML_PARSE_NONET));
}

bool refersToFile(const xmlNode& node) {
  return node.type == XML_ELEMENT_NODE &&
         (xmlStrEqual(node.name, asXml("include")) || xmlStrEqual(node.name, asXml("import")));
}

/// Adds the other parts of XABSL 2.1.
void join(xmlNode& root, xmlDoc& joined) {
  for (const auto part : {schema::parameter, schema::symbols, schema::basicBehaviors,
                          schema::optionDefinitions, schema::option, schema::agentCollection}) {
    const Document document = parse(part());
    for (xmlNode* node = xmlDocGetRootElement(document.get())->children; node; node = node->next)
      xmlAddChild(&root, xmlDocCopyNode(node, &joined, 1));
  }
}

/// All schemas of a dialect joined to one, so that nothing is read from disk.
Document joinedSchema(Dialect dialect) {
  const bool old = dialect == Dialect::xabsl21;
  Document joined = parse(old ? schema::expressions() : schema::xabsl31());
  xmlNode* root = xmlDocGetRootElement(joined.get());
  if (old) join(*root, *joined);
  for (xmlNode* node = root->children; node;) {
    xmlNode* const next = node->next;
    if (refersToFile(*node)) {
      xmlUnlinkNode(node);
      xmlFreeNode(node);
    }
    node = next;
  }
  return joined;
}

/// Removes namespaces, line ends and full stops from a message.
std::string withoutNamespaces(std::string_view message) {
  std::string text;
  while (!message.empty()) {
    const std::size_t open = message.find('{');
    text += message.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = message.find('}', open);
    message = close == std::string_view::npos ? "" : message.substr(close + 1);
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' '))
    text.pop_back();
  if (!text.empty() && text.front() == 'E') text.front() = 'e';
  return text;
}

/// Sends elements to the validator of libxml2, one after another, and keeps track of the present
/// one.
class Validator {
 public:
  Validator(xmlSchema& schema, const Files& files, Reporter& reporter)
      : files_(files), reporter_(reporter), schema_(schema) {}

  void validate(const std::vector<Element>& roots, Follow follow) {
    follow_ = follow;
    forEach(files_, roots, follow, [&](const Element& root) {
      if (root.kind == Element::Kind::element) validateRoot(root);
    });
  }

 private:
  void validateRoot(const Element& root) {
    const std::unique_ptr<xmlSchemaValidCtxt, ValidatorDeleter> validator(
        xmlSchemaNewValidCtxt(&schema_));
    xmlSchemaSetValidStructuredErrors(
        validator.get(), [](void* self, auto* error) { problem(self, *error); }, this);
    xmlSAXHandler* handler = nullptr;
    void* user = nullptr;
    xmlSchemaSAXPlugStruct* plug = xmlSchemaSAXPlug(validator.get(), &handler, &user);
    if (!plug) return;
    handler_ = handler;
    user_ = user;
    current_ = &root;
    if (handler_->startDocument) handler_->startDocument(user_);
    element(root);
    if (handler_->endDocument) handler_->endDocument(user_);
    xmlSchemaSAXUnplug(plug);
  }

  void element(const Element& element) {
    const bool include = element.kind == Element::Kind::include;
    if (element.kind == Element::Kind::comment || reporter_.full()) return;
    current_ = &element;
    const std::string name(include ? "include" : element.name);
    const std::string space(include ? "http://www.w3.org/2001/XInclude"
                                    : namespaceOf(files_.front().dialect));
    std::vector<std::string> names;
    for (const Attribute& attribute : element.attributes) names.emplace_back(attribute.name);
    std::vector<const xmlChar*> attributes;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string_view value = element.attributes[i].value;
      const char* begin = value.empty() ? "" : value.data();
      attributes.insert(attributes.end(),
                        {asXml(names[i]), nullptr, nullptr, reinterpret_cast<const xmlChar*>(begin),
                         reinterpret_cast<const xmlChar*>(begin + value.size())});
    }
    handler_->startElementNs(user_, asXml(name), nullptr, asXml(space), 0, nullptr,
                             static_cast<int>(names.size()), 0, attributes.data());
    if (!element.text.empty() && !include)
      handler_->characters(user_, reinterpret_cast<const xmlChar*>(element.text.data()),
                           static_cast<int>(element.text.size()));
    if (!include) children(element);
    current_ = &element;
    handler_->endElementNs(user_, asXml(name), nullptr, asXml(space));
  }

  /// A collection is included by very many options. Where it was validated before, its first entry
  /// stands for all.
  void children(const Element& parent) {
    const bool collection =
        parent.is("symbols") || parent.is("basic-behaviors") || parent.is("option-definitions");
    const bool known = collection && !known_.insert(&parent).second;
    bool first = true;
    forEach(files_, parent.children, follow_, [&](const Element& child) {
      if (child.kind == Element::Kind::comment || (known && !first)) return;
      element(child);
      first = false;
    });
  }

  static void problem(void* context, const xmlError& error) {
    auto& validator = *static_cast<Validator*>(context);
    const std::string message = withoutNamespaces(error.message ? error.message : "");
    Location location = validator.current_->location;
    for (const Attribute& attribute : validator.current_->attributes)
      if (message.find("attribute '" + std::string(attribute.name) + "'") != std::string::npos)
        location = attribute.location;
    // A value that is wrong is reported twice: with its type, then with the pattern of the type.
    if (error.code == XML_SCHEMAV_CVC_ATTRIBUTE_4) return;
    // What several files include is validated with each of them.
    const auto report = std::tuple(location.file, location.line, location.column, message);
    if (validator.reported_.insert(report).second) validator.reporter_.error(location, message);
  }

  const Files& files_;
  Reporter& reporter_;
  xmlSchema& schema_;
  Follow follow_ = Follow::entities;
  std::set<const Element*> known_;
  std::set<std::tuple<int, int, int, std::string>> reported_;
  const Element* current_ = nullptr;
  xmlSAXHandler* handler_ = nullptr;
  void* user_ = nullptr;
};

}  // namespace

void validate(const Files& files, Reporter& reporter) {
  const Document document = joinedSchema(files.front().dialect);
  const std::unique_ptr<xmlSchemaParserCtxt, SchemaParserDeleter> parser(
      xmlSchemaNewDocParserCtxt(document.get()));
  const std::unique_ptr<xmlSchema, SchemaDeleter> schema(xmlSchemaParse(parser.get()));
  if (!schema) return reporter.fileError(files.front().path, "the XML Schema cannot be used");
  Validator validator(*schema, files, reporter);
  // What others include comes first, so that it is validated as a file of its own.
  for (auto file = files.rbegin(); file != files.rend() && !reporter.full(); ++file)
    validator.validate(file->roots, Follow::entities);
  if (!reporter.failed()) validator.validate(files.front().roots, Follow::everything);
}

}  // namespace xabsl::xml
