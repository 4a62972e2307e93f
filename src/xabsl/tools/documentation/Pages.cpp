#include "xabsl/tools/documentation/Pages.h"

#include <algorithm>

#include "xabsl/tools/documentation/Html.h"

namespace xabsl::documentation {

std::string anchor(const std::string& address, std::string_view text) {
  return "<a href=\"" + escaped(address) + "\">" + escaped(text) + "</a>";
}

std::string code(std::string_view text) {
  return "<code>" + escaped(text) + "</code>";
}

std::string title(const std::string& kind, const std::string& name) {
  return "<p class=\"kind\">" + kind + "</p>\n<h1>" + escaped(name) + "</h1>\n";
}

std::string declared(const Model& model, Location location) {
  const std::size_t file = at(location.file);
  if (location.file < 0 || file >= model.files.size()) return {};
  return "<p class=\"source\">" + escaped(model.files[file] + ":" + std::to_string(location.line)) +
         "</p>\n";
}

std::string chart(const std::string& svg, const std::string& what) {
  if (svg.empty()) return "<p class=\"soft\">The chart would be too large to read.</p>\n";
  return "<div class=\"chart\" role=\"img\" aria-label=\"" + escaped(what) + "\">" + svg +
         "</div>\n";
}

std::string typeText(const Content& content, Type type) {
  if (type.kind == ValueKind::number) return "float";
  if (type.kind == ValueKind::boolean) return "bool";
  return "enum " + anchor(content.links.enumeration(type.enumeration),
                          content.model.enumerations[at(type.enumeration)].name);
}

std::string measure(const std::string& range, const std::string& unit) {
  std::string text = range.empty() ? "" : "[" + range + "]";
  if (!text.empty() && !unit.empty()) text += ' ';
  return escaped(text + unit);
}

std::string parameterTable(const Content& content, const std::vector<Parameter>& parameters,
                           const std::string& prefix) {
  if (parameters.empty()) return {};
  std::string text =
      "<table class=\"parameters\"><thead><tr><th>Parameter</th><th>Type</th>"
      "<th>Range, unit</th><th></th></tr></thead><tbody>\n";
  for (const Parameter& parameter : parameters)
    text += "<tr><td>" + code(prefix + parameter.name) + "</td><td>" +
            typeText(content, parameter.type) + "</td><td>" +
            measure(parameter.range, parameter.unit) + "</td><td>" +
            escaped(plainDoc(parameter.doc)) + "</td></tr>\n";
  return text + "</tbody></table>\n";
}

std::string places(const Content& content, const Thing& thing) {
  const Model& model = content.model;
  std::string text;
  int option = -1;
  for (const Place& place : content.usage.places(thing)) {
    if (place.option != option) {
      if (option >= 0) text += "</span> ";
      text += "<span class=\"use\">" +
              anchor(content.links.option(place.option), model.options[at(place.option)].name);
      option = place.option;
    }
    text += " <small>" +
            (place.state < 0
                 ? std::string("every state")
                 : anchor(content.links.state(place.state), model.states[at(place.state)].name)) +
            "</small>";
  }
  return option < 0 ? text : text + "</span>";
}

bool holdsAnything(const Model& model, int space) {
  const auto holds = [space](const auto& list) {
    return std::any_of(list.begin(), list.end(),
                       [space](const auto& element) { return element.space == space; });
  };
  return holds(model.symbols) || holds(model.constants) || holds(model.enumerations) ||
         holds(model.behaviors);
}

}  // namespace xabsl::documentation
