#include "xabsl/tools/documentation/Html.h"
#include "xabsl/tools/documentation/Pages.h"

/// The page of a namespace: symbols, constants, enumerations and basic behaviors, and the options
/// that use them.
namespace xabsl::documentation {

namespace {

std::string used(const std::string& how, const std::string& places) {
  return places.empty() ? "" : "<p class=\"users\">" + how + " " + places + "</p>\n";
}

std::string notUsed(const std::string& users) {
  return users.empty() ? "<p class=\"users soft\">Used by no option.</p>\n" : users;
}

std::string begin(std::string_view kind, const std::string& name) {
  return "<section class=\"entry\" id=\"" + Links::fragment(kind, name) + "\">\n<h3>" +
         escaped(name) + "</h3>\n";
}

std::string signature(const std::string& type, const std::string& measure) {
  return "<p class=\"signature\">" + type + (measure.empty() ? "" : " · " + measure) + "</p>\n";
}

std::string symbolEntry(const Content& content, int index) {
  const Symbol& symbol = content.model.symbols[at(index)];
  const std::string kind = wordOf(symbol.kind);
  return begin(Links::kindOf(symbol), symbol.name) +
         signature(kind + " " + typeText(content, symbol.type),
                   measure(symbol.range, symbol.unit)) +
         paragraphs(symbol.doc) + parameterTable(content, symbol.parameters) +
         notUsed(used("Read by", places(content, {Thing::Kind::read, index})) +
                 used("Written by", places(content, {Thing::Kind::written, index}))) +
         "</section>\n";
}

std::string constantEntry(const Content& content, int index) {
  const Constant& constant = content.model.constants[at(index)];
  return begin("constant", constant.name) +
         signature("constant = " + escaped(constant.digits), measure("", constant.unit)) +
         paragraphs(constant.doc) +
         notUsed(used("Read by", places(content, {Thing::Kind::constant, index}))) + "</section>\n";
}

std::string enumerationEntry(const Content& content, int index) {
  const Enumeration& enumeration = content.model.enumerations[at(index)];
  std::string text = begin("enumeration", enumeration.name) +
                     signature(enumeration.internal ? "internal enumeration" : "enumeration", "") +
                     paragraphs(enumeration.doc) +
                     "<table class=\"elements\"><thead><tr><th>Element</th><th>used by</th></tr>"
                     "</thead><tbody>\n";
  for (std::size_t i = 0; i < enumeration.elements.size(); ++i)
    text += "<tr><td>" + code(enumeration.elements[i].name) + "</td><td>" +
            places(content, {Thing::Kind::element, index, static_cast<int>(i)}) + "</td></tr>\n";
  return text + "</tbody></table>\n</section>\n";
}

std::string behaviorEntry(const Content& content, int index) {
  const BasicBehavior& behavior = content.model.behaviors[at(index)];
  return begin("behavior", behavior.name) + paragraphs(behavior.doc) +
         parameterTable(content, behavior.parameters) +
         notUsed(used("Called by", places(content, {Thing::Kind::behavior, index}))) +
         "</section>\n";
}

/// The entries of one list that are declared in the namespace, below a heading.
template <typename List, typename Entry>
std::string entries(const Content& content, int space, const List& list, const std::string& heading,
                    Entry entry) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].space == space) text += entry(content, static_cast<int>(i));
  return text.empty() ? text : "<h2>" + heading + "</h2>\n" + text;
}

}  // namespace

std::string namespacePage(const Content& content, int space) {
  const Model& model = content.model;
  std::string text = space < 0 ? title("Namespace", "none") : "";
  if (space >= 0) {
    const Namespace& found = model.namespaces[at(space)];
    text = title("Namespace " + code(found.name), found.title.empty() ? found.name : found.title) +
           paragraphs(found.doc);
  }
  text += entries(content, space, model.behaviors, "Basic behaviors", behaviorEntry) +
          entries(content, space, model.symbols, "Symbols", symbolEntry) +
          entries(content, space, model.constants, "Constants", constantEntry) +
          entries(content, space, model.enumerations, "Enumerations", enumerationEntry);
  return space < 0 ? text : text + declared(model, model.namespaces[at(space)].location);
}

}  // namespace xabsl::documentation
