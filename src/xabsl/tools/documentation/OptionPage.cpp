#include <algorithm>

#include "xabsl/language/ModelText.h"
#include "xabsl/language/Warnings.h"
#include "xabsl/tools/documentation/Html.h"
#include "xabsl/tools/documentation/Pages.h"

/// The page of an option: its chart, its states with their decision trees, what it reads and
/// writes.
namespace xabsl::documentation {

namespace {

std::string callers(const Content& content, int option) {
  std::string text;
  for (std::size_t i = 0; i < content.model.agents.size(); ++i)
    if (content.model.agents[i].rootOption == option)
      text += "<span class=\"use\">agent " +
              anchor(content.links.agent(static_cast<int>(i)), content.model.agents[i].name) +
              "</span> ";
  text += places(content, {Thing::Kind::option, option});
  return text.empty() ? "<p class=\"soft\">Called by no option.</p>\n"
                      : "<p>Called by " + text + "</p>\n";
}

std::string actionList(const Content& content, Span actions) {
  const Model& model = content.model;
  if (actions.count == 0) return "<p class=\"soft\">No actions.</p>\n";
  std::string text = "<ul class=\"actions\">\n";
  for (const Action& action : actions.of(model.actions)) {
    const std::string whole = actionText(model, action);
    const std::string& name = targetName(model, action);
    text += "<li><code>" + anchor(content.links.target(thingOf(action)), name) +
            escaped(whole.substr(name.size())) + "</code></li>\n";
  }
  return text + "</ul>\n";
}

std::string badges(const Content& content, const Option& option, int index) {
  const State& state = content.model.states[at(index)];
  std::string text;
  const auto add = [&text](const std::string& badge) {
    text += " <span class=\"badge\">" + badge + "</span>";
  };
  if (option.initialState == index) add("initial");
  if (state.target) add("target");
  if (!enteredStates(content.model, option)[at(index - option.states.first)]) add("never entered");
  const std::string agents = std::to_string(state.cooperation.agents);
  if (state.cooperation.kind == Cooperation::Kind::capacity) add("capacity " + agents);
  if (state.cooperation.kind == Cooperation::Kind::synchronized) add("synchronized " + agents);
  return text;
}

std::string stateSection(const Content& content, const Option& option, int index) {
  const State& state = content.model.states[at(index)];
  return "<section id=\"" + Links::fragment("state", state.name) + "\">\n<h3>" +
         escaped(state.name) + badges(content, option, index) + "</h3>\n" + paragraphs(state.doc) +
         actionList(content, state.actions) +
         chart(content.charts.states[at(index)], "Decision tree of the state " + state.name) +
         "</section>\n";
}

/// The names of states with links, as in `begin, going_on`; or a text for all states.
std::string stateNames(const Content& content, const std::vector<int>& states) {
  std::string text;
  for (const int state : states) {
    if (!text.empty()) text += ", ";
    text += state < 0 ? "every state"
                      : anchor(content.links.state(state), content.model.states[at(state)].name);
  }
  return text;
}

/// The options called by an option that use something themselves or through others.
std::string throughOptions(const Content& content, int option, const Thing& thing) {
  std::string text;
  for (const auto& [callee, states] : content.usage.direct(option)) {
    if (callee.kind != Thing::Kind::option || content.usage.all(callee.index).count(thing) == 0)
      continue;
    if (!text.empty()) text += ", ";
    text +=
        anchor(content.links.option(callee.index), content.model.options[at(callee.index)].name);
  }
  return text;
}

/// A table of the things of one kind that an option uses, directly and through its subsequent
/// options.
template <typename Describe>
std::string useTable(const Content& content, int option, Thing::Kind kind,
                     const std::string& heading, Describe describe) {
  std::string rows;
  const auto& direct = content.usage.direct(option);
  for (const Thing& thing : content.usage.all(option)) {
    if (thing.kind != kind) continue;
    const auto own = direct.find(thing);
    rows += "<tr><td>" + describe(thing) + "</td><td>" +
            (own == direct.end() ? "" : stateNames(content, own->second)) + "</td><td>" +
            throughOptions(content, option, thing) + "</td></tr>\n";
  }
  if (rows.empty()) return {};
  return "<table class=\"uses\"><thead><tr><th>" + heading +
         "</th><th>in its states</th><th>through its subsequent options</th></tr></thead><tbody>" +
         rows + "</tbody></table>\n";
}

std::string uses(const Content& content, int option) {
  const Model& model = content.model;
  const auto symbol = [&](const Thing& thing) {
    const Symbol& found = model.symbols[at(thing.index)];
    const std::string unit = measure("", found.unit);
    return anchor(content.links.symbol(thing.index), found.name) +
           (unit.empty() ? "" : " <small>" + unit + "</small>");
  };
  const std::string tables = useTable(content, option, Thing::Kind::read, "Reads", symbol) +
                             useTable(content, option, Thing::Kind::written, "Writes", symbol) +
                             useTable(content, option, Thing::Kind::option, "Calls the option",
                                      [&](const Thing& thing) {
                                        return anchor(content.links.option(thing.index),
                                                      model.options[at(thing.index)].name);
                                      }) +
                             useTable(content, option, Thing::Kind::behavior,
                                      "Calls the basic behavior", [&](const Thing& thing) {
                                        return anchor(content.links.behavior(thing.index),
                                                      model.behaviors[at(thing.index)].name);
                                      });
  return "<h2 id=\"uses\">What it reads, writes and calls</h2>\n" +
         (tables.empty() ? "<p class=\"soft\">Nothing.</p>\n" : tables);
}

}  // namespace

std::string optionPage(const Content& content, int index) {
  const Option& option = content.model.options[at(index)];
  std::string text = title("Option", option.name) + paragraphs(option.doc) +
                     callers(content, index) + parameterTable(content, option.parameters, "@") +
                     chart(content.charts.options[at(index)],
                           "States of the option " + option.name + " and what they call");
  if (option.commonDecision.kind == Branch::Kind::decision)
    text +=
        "<section id=\"common-decision\">\n<h2>Common decision</h2>\n"
        "<p class=\"soft\">Asked in every state before its own decision tree.</p>\n" +
        chart(content.charts.commonDecisions[at(index)], "Common decision tree") + "</section>\n";
  if (option.commonActions.count > 0)
    text += "<section id=\"common-action\">\n<h2>Actions in every state</h2>\n" +
            actionList(content, option.commonActions) + "</section>\n";
  text += "<h2 id=\"states\">States</h2>\n";
  for (const int i : option.states) text += stateSection(content, option, i);
  return text + uses(content, index) + declared(content.model, option.location);
}

}  // namespace xabsl::documentation
