#include "xabsl/formats/xml/XmlParser.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "xabsl/language/Text.h"

/// The part of the parser for declarations: agents, symbols, basic behaviors and prototypes of
/// options (report F.2 to F.4, F.10).
namespace xabsl::xml {

using namespace syntax;

namespace {

bool isCollection(const Element& element) {
  return element.is("symbols") || element.is("basic-behaviors") || element.is("option-definitions");
}

constexpr std::string_view booleanPrefix = "boolean-", enumeratedPrefix = "enumerated-";

bool isOutput(const Element& element) {
  constexpr std::string_view ending = "-output-symbol";
  return element.name.size() > ending.size() &&
         element.name.substr(element.name.size() - ending.size()) == ending;
}

bool isInternal(const Element& element) {
  return isTrue(element.attribute("internal"));
}

/// Whether two elements are equal except for their places, so that a collection may be written in
/// several places.
bool same(const Element& a, const Element& b) {
  if (a.kind != b.kind || a.name != b.name || a.text != b.text || a.file != b.file ||
      a.attributes.size() != b.attributes.size() || a.children.size() != b.children.size())
    return false;
  for (std::size_t i = 0; i < a.attributes.size(); ++i)
    if (a.attributes[i].name != b.attributes[i].name ||
        a.attributes[i].value != b.attributes[i].value)
      return false;
  for (std::size_t i = 0; i < a.children.size(); ++i)
    if (!same(a.children[i], b.children[i])) return false;
  return true;
}

/// The common prefix of all elements before their last point, or nothing.
std::string_view commonPrefix(const Enumeration& enumeration) {
  std::string_view prefix;
  for (const Name& element : enumeration.elements) {
    const std::string_view own = element.text.substr(0, element.text.rfind('.'));
    if (own.size() == element.text.size() || own.empty()) return {};
    if (&element != &enumeration.elements.front() && own != prefix) return {};
    prefix = own;
  }
  return prefix;
}

/// Whether an enumeration has the same elements as another one, with or without its name as a
/// prefix.
bool haveSameElements(const Enumeration& known, const Enumeration& other) {
  const std::string_view owner = known.name.text;
  return std::equal(known.elements.begin(), known.elements.end(), other.elements.begin(),
                    other.elements.end(), [&](const Name& a, const Name& b) {
                      return withoutOwner(a.text, owner) == withoutOwner(b.text, owner);
                    });
}

}  // namespace

Parser::Parser(const Files& files, Reporter& reporter, Program& program)
    : files_(files), reporter_(reporter), program_(program) {}

void Parser::parse() {
  program_.dialect = files_.front().dialect;
  comments();
  const Element* root = nullptr;
  for (const Element& element : files_.front().roots)
    if (element.kind == Element::Kind::element) root = &element;
  if (!root) return reporter_.fileError(files_.front().path, "there is no element");
  if (root->is("agent-collection")) return agentCollection(*root);
  reporter_.error(root->location, "expected the file with the agents ('agent-collection'), found " +
                                      inQuotes(root->name));
}

/// Keeps comments, as comments of XABSL text, for tools that rewrite the program.
void Parser::comments() {
  const auto add = [&](const auto& self, const std::vector<Element>& elements) -> void {
    for (const Element& element : elements) {
      if (element.kind == Element::Kind::comment) {
        std::string text(element.text);
        for (std::size_t end = text.find("*/"); end != std::string::npos; end = text.find("*/"))
          text.replace(end, 2, "* /");
        program_.files[at(element.location.file)].comments.push_back(
            {Comment::Kind::block,
             program_.keep("/* " + text + " */"),
             {element.location, element.location}});
      }
      self(self, element.children);
    }
  };
  for (const File& file : files_) add(add, file.roots);
}

void Parser::agentCollection(const Element& root) {
  std::vector<const Element*> options;
  for (const Element* element : elementsOf(root)) {
    if (element->is("title")) program_.header.title = element->text;
    if (element->is("platform")) program_.header.platform = element->text;
    if (element->is("software-environment")) program_.header.softwareEnvironment = element->text;
    if (element->is("agent")) agent(*element);
    if (element->is("option-definitions")) declare(*element);
    if (element->is("options")) options = elementsOf(*element);
  }
  for (const Element* element : options) collect(*element);
  for (const Element* element : options)
    if (element->is("option") && !reporter_.full()) option(*element);
}

void Parser::agent(const Element& element) {
  auto agent = declared<Agent>(element, "id");
  agent.title = element.attribute("title");
  const Attribute* root = element.find("root-option");
  agent.rootOption = {root->value, root->location};
  program_.agents.push_back(agent);
}

void Parser::collect(const Element& option) {
  for (const Element* element : elementsOf(option))
    if (isCollection(*element)) declare(*element);
}

/// Each option includes the same collections. Equal ones count once; different ones with the same
/// key are an error.
bool Parser::isNew(const Element& collection, const std::string& key) {
  const auto [known, added] = collections_.emplace(key, &collection);
  if (added || known->second == &collection || same(*known->second, collection)) return added;
  const Location& other = known->second->location;
  reporter_.error(collection.location, inQuotes(key) + " is declared otherwise in " +
                                           files_[at(other.file)].path + ":" +
                                           std::to_string(other.line));
  return false;
}

void Parser::declare(const Element& collection) {
  if (collection.is("option-definitions")) {
    const Element* last = nullptr;
    for (const auto& [name, prototype] : entriesOf(collection)) {
      if (last && last->attribute("name") == name)
        error(*prototype, "name", "option " + inQuotes(name) + " has two prototypes");
      else if (isNew(*prototype, "option-definition " + std::string(name)))
        prototypes_.emplace(name, prototype);
      last = prototype;
    }
    return;
  }
  const std::string id(collection.attribute("id"));
  if (!isNew(collection, std::string(collection.name) + " " + id)) return;
  checkFileName(collection, id, "id");
  if (collection.is("symbols")) return symbols(collection);
  const int space = enterNamespace(collection, Namespace::Kind::behaviors);
  for (const Element* element : elementsOf(collection)) behavior(*element, space);
}

/// Warns if a file does not have the name that the report requires; everything works without it.
void Parser::checkFileName(const Element& element, std::string_view name,
                           const std::string& attribute) {
  const File& file = files_[at(element.location.file)];
  if (!file.roots.empty() && &file.roots.back() != &element) return;
  std::string_view stem = file.path;
  stem = stem.substr(stem.rfind('/') + 1);
  stem = stem.substr(0, stem.rfind('.'));
  if (stem == name) return;
  reporter_.warning(element.find(attribute)->location,
                    inQuotes(name) + " stands in a file of another name, expected " +
                        inQuotes(std::string(name) + ".xml"));
}

int Parser::enterNamespace(const Element& element, Namespace::Kind kind) {
  auto space = declared<Namespace>(element, "id");
  space.kind = kind;
  space.title = element.attribute("title");
  program_.namespaces.push_back(space);
  return static_cast<int>(program_.namespaces.size()) - 1;
}

void Parser::symbols(const Element& element) {
  const int space = enterNamespace(element, Namespace::Kind::symbols);
  for (const Element* child : elementsOf(element)) {
    const bool old = program_.dialect == Dialect::xabsl21;
    if (child->is("constant") || isOutput(*child)) notInputs_.insert(child->attribute("name"));
    if (child->is("constant"))
      constant(*child, space);
    else if (child->is("enumeration"))
      enumeration(*child, space);
    else if (old && child->name.substr(0, enumeratedPrefix.size()) == enumeratedPrefix)
      enumeratedSymbol(*child, space);
    else
      symbol(*child, space);
  }
}

void Parser::symbol(const Element& element, int space) {
  auto symbol = declared<Symbol>(element, "name", space);
  symbol.kind = !isOutput(element)    ? SymbolKind::input
                : isInternal(element) ? SymbolKind::internal
                                      : SymbolKind::output;
  symbol.type = type(element);
  symbol.unit = element.attribute("measure");
  symbol.range = element.attribute("range");
  symbol.parameters = parameters(element);
  program_.symbols.push_back(std::move(symbol));
}

/// The type given by the prefix of an element's name.
TypeName Parser::type(const Element& element) {
  if (element.name.substr(0, booleanPrefix.size()) == booleanPrefix)
    return {ValueKind::boolean, {}};
  if (element.name.substr(0, enumeratedPrefix.size()) != enumeratedPrefix) return {};
  const Attribute* name = element.find("enumeration");
  return {ValueKind::enumeration, {name->value, name->location}};
}

void Parser::enumeration(const Element& element, int space) {
  auto enumeration = declared<Enumeration>(element, "name", space);
  enumeration.internal = isInternal(element);
  for (const Element* child : elementsOf(element)) {
    const Attribute* name = child->find("name");
    enumeration.elements.push_back({name->value, name->location});
    notInputs_.insert(name->value);
    notInputs_.insert(withoutOwner(name->value, enumeration.name.text));
  }
  program_.enumerations.push_back(std::move(enumeration));
}

/// In 2.1 each enumerated symbol has separate elements. Their enumeration gets their common prefix
/// as its name (`op-mode.fast`), otherwise the name of the symbol; symbols with the same elements
/// share it.
void Parser::enumeratedSymbol(const Element& element, int space) {
  auto enumeration = declared<Enumeration>(element, "name", space);
  enumeration.doc = {};
  for (const Element* child : elementsOf(element)) {
    const Attribute* name = child->find("name");
    enumeration.elements.push_back({name->value, name->location});
  }
  auto symbol = declared<Symbol>(element, "name", space);
  symbol.kind = element.is("enumerated-input-symbol") ? SymbolKind::input : SymbolKind::output;
  symbol.type = {ValueKind::enumeration, enumeration.name};
  const std::string_view prefix = commonPrefix(enumeration);
  for (const std::string_view name : {prefix, symbol.name.text}) {
    if (name.empty()) continue;
    const auto known =
        std::find_if(program_.enumerations.begin(), program_.enumerations.end(),
                     [&](const Enumeration& other) { return other.name.text == name; });
    const bool taken = known != program_.enumerations.end();
    if (taken && !haveSameElements(*known, enumeration)) continue;
    enumeration.name.text = name;
    symbol.type.enumeration = enumeration.name;
    if (taken) return program_.symbols.push_back(std::move(symbol));
    break;
  }
  program_.enumerations.push_back(std::move(enumeration));
  program_.symbols.push_back(std::move(symbol));
}

void Parser::constant(const Element& element, int space) {
  auto constant = declared<Constant>(element, "name", space);
  const ExpressionPtr value = number(element);
  constant.negative = value->kind == Expression::Kind::operation;
  const Expression& literal = constant.negative ? *value->operands.front() : *value;
  constant.digits = literal.name;
  constant.value = constant.negative ? -literal.number : literal.number;
  constant.unit = element.attribute("measure");
  program_.constants.push_back(constant);
}

void Parser::behavior(const Element& element, int space) {
  auto behavior = declared<Behavior>(element, "name", space);
  behavior.parameters = parameters(element);
  program_.behaviors.push_back(std::move(behavior));
}

std::vector<Parameter> Parser::parameters(const Element& owner) {
  std::vector<Parameter> parameters;
  for (const Element* element : elementsOf(owner)) {
    auto parameter = declared<Parameter>(*element, "name");
    parameter.name.text = withoutOwner(parameter.name.text, owner.attribute("name"));
    parameter.type = type(*element);
    parameter.range = element->attribute("range");
    parameter.unit = element->attribute("measure");
    parameters.push_back(parameter);
  }
  return parameters;
}

/// Reads a decimal value; a negative one becomes a sign and a number, as in XABSL text.
ExpressionPtr Parser::number(const Element& element) {
  const Attribute* value = element.find("value");
  std::string_view digits = value->value;
  const bool negative = digits.substr(0, 1) == "-";
  if (negative || digits.substr(0, 1) == "+") digits.remove_prefix(1);
  // A number of the schema may begin or end with its point; that of XABSL text may not.
  std::string whole(digits);
  if (whole.substr(0, 1) == ".") whole = "0" + whole;
  if (!whole.empty() && whole.back() == '.') whole += "0";
  auto literal = std::make_unique<Expression>();
  literal->location = element.location;
  literal->extent = {element.location, element.location};
  literal->name = program_.keep(std::move(whole));
  const char* end = literal->name.data() + literal->name.size();
  if (std::from_chars(literal->name.data(), end, literal->number).ec != std::errc())
    reporter_.error(value->location, "number " + inQuotes(value->value) + " is out of range");
  if (!negative) return literal;
  auto sign = std::make_unique<Expression>();
  sign->kind = Expression::Kind::operation;
  sign->operation = Operator::negate;
  sign->location = element.location;
  sign->extent = literal->extent;
  sign->depth = 2;
  sign->operands.push_back(std::move(literal));
  return sign;
}

const Parser::Entries& Parser::entriesOf(const Element& collection) {
  const auto [found, added] = entries_.emplace(&collection, Entries());
  if (!added) return found->second;
  for (const Element* element : elementsOf(collection))
    found->second.emplace(element->attribute("name"), element);
  return found->second;
}

std::vector<const Element*> Parser::elementsOf(const Element& parent) const {
  std::vector<const Element*> elements;
  forEach(files_, parent.children, Follow::everything, [&](const Element& element) {
    if (element.kind == Element::Kind::element) elements.push_back(&element);
  });
  return elements;
}

void Parser::error(const Element& element, std::string_view attribute, const std::string& message) {
  const Attribute* found = element.find(attribute);
  reporter_.error(found ? found->location : element.location, message);
}

}  // namespace xabsl::xml
