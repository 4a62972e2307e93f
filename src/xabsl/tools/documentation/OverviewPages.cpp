#include "xabsl/language/Lowering.h"
#include "xabsl/tools/documentation/Html.h"
#include "xabsl/tools/documentation/Pages.h"

/// The first page, the pages of the agents, and the entries of the search field.
namespace xabsl::documentation {

namespace {

std::string table(const std::string& rows) {
  return rows.empty() ? rows : "<table class=\"list\"><tbody>\n" + rows + "</tbody></table>\n";
}

std::string row(const std::string& address, const std::string& name, const std::string& about) {
  return "<tr><td>" + anchor(address, name) + "</td><td>" + escaped(about) + "</td></tr>\n";
}

std::string optionRows(const Content& content, const std::vector<int>& options) {
  std::string rows;
  for (const int i : options)
    rows += row(content.links.option(i), content.model.options[at(i)].name,
                firstSentence(content.model.options[at(i)].doc));
  return rows;
}

std::string namespaceRow(const Content& content, int space) {
  const Model& model = content.model;
  if (space < 0) return row(content.links.space(-1), "in none", "");
  const Namespace& found = model.namespaces[at(space)];
  const std::string name = found.title.empty() ? found.name : found.title;
  return row(content.links.space(space), name, firstSentence(found.doc));
}

}  // namespace

std::string agentPage(const Content& content, int index) {
  const Model& model = content.model;
  const Agent& agent = model.agents[at(index)];
  std::vector<int> reached;
  for (const int option : sortedByName(model.options))
    if (option == agent.rootOption ||
        content.usage.all(agent.rootOption).count({Thing::Kind::option, option}) > 0)
      reached.push_back(option);
  return title("Agent " + code(agent.name), agent.title.empty() ? agent.name : agent.title) +
         paragraphs(agent.doc) + "<p>Root option: " +
         anchor(content.links.option(agent.rootOption), model.options[at(agent.rootOption)].name) +
         "</p>\n" + chart(content.charts.agents[at(index)], "Option graph of " + agent.name) +
         "<h2>Options</h2>\n" + table(optionRows(content, reached)) +
         declared(model, agent.location);
}

std::string overviewPage(const Content& content) {
  const Model& model = content.model;
  std::string about = model.platform;
  if (!model.softwareEnvironment.empty())
    about += (about.empty() ? "" : ", ") + model.softwareEnvironment;
  std::string text = title("Behavior", model.title.empty() ? "XABSL" : model.title) +
                     (about.empty() ? "" : "<p>" + escaped(about) + "</p>\n") + "<h2>Agents</h2>\n";
  std::string agents;
  for (std::size_t i = 0; i < model.agents.size(); ++i)
    agents += row(content.links.agent(static_cast<int>(i)),
                  model.agents[i].title.empty() ? model.agents[i].name : model.agents[i].title,
                  firstSentence(model.agents[i].doc));
  text += table(agents);
  if (!model.agents.empty())
    text += chart(content.charts.agents[0], "Option graph of " + model.agents[0].name);
  text += "<h2>Options</h2>\n" + table(optionRows(content, sortedByName(model.options))) +
          "<h2>Symbols and basic behaviors</h2>\n";
  std::string spaces = holdsAnything(model, -1) ? namespaceRow(content, -1) : "";
  for (std::size_t i = 0; i < model.namespaces.size(); ++i)
    spaces += namespaceRow(content, static_cast<int>(i));
  return text + table(spaces);
}

std::string searchEntries(const Content& content) {
  const Model& model = content.model;
  std::string text = "const entries = [\n";
  const auto add = [&](const char* kind, const std::string& name, const std::string& address) {
    text += "[\"" + std::string(kind) + "\"," + quotedScript(name) + "," + quotedScript(address) +
            "],\n";
  };
  const auto addAll = [&](const char* kind, const auto& list, auto address) {
    for (const int i : sortedByName(list)) add(kind, list[at(i)].name, address(i));
  };
  const Links& links = content.links;
  addAll("agent", model.agents, [&](int i) { return links.agent(i); });
  addAll("option", model.options, [&](int i) { return links.option(i); });
  for (const int i : sortedByName(model.states))
    add("state", model.options[at(links.optionOf(i))].name + "." + model.states[at(i)].name,
        links.state(i));
  addAll("behavior", model.behaviors, [&](int i) { return links.behavior(i); });
  addAll("symbol", model.symbols, [&](int i) { return links.symbol(i); });
  addAll("constant", model.constants, [&](int i) { return links.constant(i); });
  addAll("enumeration", model.enumerations, [&](int i) { return links.enumeration(i); });
  return text + "];\n";
}

}  // namespace xabsl::documentation
