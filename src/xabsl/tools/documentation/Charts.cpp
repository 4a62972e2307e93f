#include "xabsl/tools/documentation/Charts.h"

#include <set>
#include <utility>

#include "xabsl/language/ModelText.h"
#include "xabsl/tools/documentation/Html.h"

namespace xabsl::documentation {

namespace {

/// A string of Graphviz's language, in which labels may contain entities, and lines end with `\l`.
std::string inGraph(std::string_view text) {
  std::string result = "\"";
  for (const char c : escaped(text)) {
    if (c == '\\')
      result += "\\\\";
    else if (c == '\n')
      result += "\\l";
    else
      result += c;
  }
  return result + '"';
}

/// A graph that is being written: nodes with a class for the style sheet, and edges.
class Graph {
 public:
  explicit Graph(const std::string& settings)
      : text_("digraph chart {\n  bgcolor=transparent; fontname=\"sans-serif\"; pad=0.1; " +
              settings +
              "\n  node [fontname=\"sans-serif\", fontsize=10, height=0.3, margin=\"0.12,0.05\"];\n"
              "  edge [fontname=\"sans-serif\", fontsize=9, arrowsize=0.7];\n") {}

  void node(const std::string& id, const std::string& kind, const std::string& label,
            const std::string& attributes = {}) {
    text_ += "  " + id + " [class=\"" + kind + "\", label=" + inGraph(label) + attributes + "];\n";
    ++size_;
  }

  void edge(const std::string& from, const std::string& to, const std::string& kind,
            const std::string& attributes = {}) {
    text_ += "  " + from + " -> " + to + " [class=\"" + kind + "\"" + attributes + "];\n";
    ++size_;
  }

  void add(const std::string& line) { text_ += "  " + line + "\n"; }

  /// An identifier that no other node has.
  std::string freshId() const { return "n" + std::to_string(size_); }

  /// Large graphs are drawn with straight lines, and not with the best order of the nodes: that
  /// takes minutes. Nothing, if nobody could read it.
  std::string take() {
    constexpr std::size_t large = 250, largest = 1600;
    if (size_ > largest) return {};
    if (size_ > large) add("splines=line; nslimit=1; nslimit1=1; mclimit=0.05;");
    return std::move(text_) + "}\n";
  }

 private:
  std::string text_;
  std::size_t size_ = 0;
};

/// Attributes of a node or edge that links to a page: the address and the tooltip.
std::string linked(const std::string& address, const std::string& tooltip) {
  return ", URL=" + inGraph(address) + ", tooltip=" + inGraph(tooltip.empty() ? " " : tooltip);
}

std::string id(const char* kind, int index) {
  return kind + std::to_string(index);
}

/// A text in lines of a readable width, each with a break at its end: conditions are broken behind
/// `&&` and `||`, sentences at any blank.
std::string wrapped(const std::string& text, bool condition) {
  const std::size_t width = condition ? 18 : 40;
  constexpr std::size_t longest = 600;
  std::string result;
  std::size_t column = 0;
  for (std::size_t i = 0; i < text.size() && i < longest; ++i) {
    result += text[i];
    ++column;
    const bool between = i > 0 && (text[i - 1] == '&' || text[i - 1] == '|');
    if (text[i] == ' ' && column >= width && (between || !condition) && i + 8 < text.size())
      result.back() = '\n';
    if (result.back() == '\n') column = 0;
  }
  return result + (text.size() > longest ? "...\n" : "\n");
}

/// Draws the charts of one model.
class Describer {
 public:
  Describer(const Model& model, const Usage& usage, const Links& links)
      : model_(model), usage_(usage), links_(links) {}

  Charts run() {
    Charts charts;
    for (const Agent& agent : model_.agents) charts.agents.push_back(optionGraph(agent.rootOption));
    for (std::size_t i = 0; i < model_.options.size(); ++i) {
      charts.options.push_back(stateMachine(static_cast<int>(i)));
      charts.commonDecisions.push_back(commonTree(static_cast<int>(i)));
    }
    for (std::size_t i = 0; i < model_.states.size(); ++i)
      charts.states.push_back(stateTree(static_cast<int>(i)));
    return charts;
  }

 private:
  void addCallee(Graph& graph, const Thing& thing) const {
    if (thing.kind == Thing::Kind::option) {
      const Option& option = model_.options[at(thing.index)];
      graph.node(id("o", thing.index), "option", option.name,
                 ", shape=box" + linked(links_.option(thing.index), firstSentence(option.doc)));
    } else {
      const BasicBehavior& behavior = model_.behaviors[at(thing.index)];
      graph.node(id("b", thing.index), "behavior", behavior.name,
                 ", shape=box, style=rounded" +
                     linked(links_.behavior(thing.index), firstSentence(behavior.doc)));
    }
  }

  static bool isCallee(const Thing& thing) {
    return thing.kind == Thing::Kind::option || thing.kind == Thing::Kind::behavior;
  }

  static std::string idOf(const Thing& callee) {
    return id(callee.kind == Thing::Kind::option ? "o" : "b", callee.index);
  }

  std::string optionGraph(int root) const {
    Graph graph("rankdir=LR; nodesep=0.12; ranksep=0.6;");
    std::set<Thing> reached = usage_.all(root);
    reached.insert({Thing::Kind::option, root});
    for (const Thing& thing : reached)
      if (isCallee(thing)) addCallee(graph, thing);
    for (const Thing& thing : reached)
      if (thing.kind == Thing::Kind::option)
        for (const auto& [callee, states] : usage_.direct(thing.index))
          if (isCallee(callee)) graph.edge(idOf(thing), idOf(callee), "call");
    return graph.take();
  }

  void addState(Graph& graph, const std::string& node, int index, const std::string& kind) const {
    const State& state = model_.states[at(index)];
    std::string tooltip = firstSentence(state.doc);
    if (state.target) tooltip += tooltip.empty() ? "Target state" : " (target state)";
    graph.node(node, kind + (state.target ? " target" : ""), state.name,
               (state.target ? ", shape=ellipse, peripheries=2" : ", shape=ellipse") +
                   linked(links_.state(index), tooltip));
  }

  /// The states a decision leads to.
  void findTargets(Branch branch, std::set<int>& targets) const {
    while (branch.kind == Branch::Kind::decision) {
      const Decision& decision = model_.decisions[at(branch.index)];
      findTargets(decision.then, targets);
      branch = decision.otherwise;
    }
    if (branch.kind == Branch::Kind::state) targets.insert(branch.index);
  }

  void addTransitions(Graph& graph, const std::string& from, int own, Branch branch,
                      const std::string& address) const {
    std::set<int> targets;
    findTargets(branch, targets);
    for (const int target : targets)
      if (target != own)
        graph.edge(from, id("s", target), "transition",
                   linked(address, "to " + model_.states[at(target)].name));
  }

  void addCalls(Graph& graph, const std::string& from, Span actions,
                std::set<Thing>& callees) const {
    std::set<Thing> known;
    for (const Action& action : actions.of(model_.actions)) {
      if (action.kind == Action::Kind::assignment) continue;
      const Thing callee = thingOf(action);
      if (callees.insert(callee).second) addCallee(graph, callee);
      if (known.insert(callee).second)
        graph.edge(from, idOf(callee), "call", ", style=dotted, arrowhead=open");
    }
  }

  std::string stateMachine(int index) const {
    const Option& option = model_.options[at(index)];
    Graph graph("rankdir=TB; nodesep=0.3; ranksep=0.5;");
    std::set<Thing> callees;
    for (const int i : option.states) addState(graph, id("s", i), i, "state");
    graph.node("start", "start", "", ", shape=point, width=0.1");
    if (option.initialState >= 0) graph.edge("start", id("s", option.initialState), "transition");
    if (option.commonDecision.kind == Branch::Kind::decision) {
      graph.node("common", "common", "common decision",
                 ", shape=box, style=dashed" + linked(links_.commonDecision(index), ""));
      addTransitions(graph, "common", -1, option.commonDecision, links_.commonDecision(index));
    }
    for (const int i : option.states)
      addTransitions(graph, id("s", i), i, model_.states[at(i)].decision, links_.state(i));
    addCalls(graph, "all", option.commonActions, callees);
    if (!callees.empty())
      graph.node("all", "common", "every state",
                 ", shape=box, style=dashed" + linked(links_.option(index) + "#common-action", ""));
    for (const int i : option.states)
      addCalls(graph, id("s", i), model_.states[at(i)].actions, callees);
    std::string last;
    for (const Thing& callee : callees) last += idOf(callee) + "; ";
    if (!last.empty()) graph.add("{rank=sink; " + last + "}");
    return graph.take();
  }

  std::string commonTree(int index) const {
    const Option& option = model_.options[at(index)];
    if (option.commonDecision.kind != Branch::Kind::decision) return {};
    Graph graph("rankdir=TB; nodesep=0.25; ranksep=0.35; ordering=out;");
    graph.node("root", "common", "common decision", ", shape=box, style=dashed");
    addBranch(graph, "root", "", option.commonDecision, -1);
    return graph.take();
  }

  std::string stateTree(int index) const {
    const State& state = model_.states[at(index)];
    const int option = links_.optionOf(index);
    Graph graph("rankdir=TB; nodesep=0.25; ranksep=0.35; ordering=out;");
    addState(graph, "root", index, "state own");
    std::string from = "root";
    if (model_.options[at(option)].commonDecision.kind == Branch::Kind::decision) {
      graph.node("common", "common", "common decision",
                 ", shape=box, style=dashed" + linked(links_.commonDecision(option), ""));
      graph.edge(from, "common", "decides");
      from = "common";
    }
    addBranch(graph, from, from == "common" ? "else" : "", state.decision, index);
    return graph.take();
  }

  /// What a branch leads to, below a node; decisions one below the other, what they choose beside
  /// them.
  void addBranch(Graph& graph, std::string from, std::string label, Branch branch, int own) const {
    while (branch.kind == Branch::Kind::decision) {
      const Decision& decision = model_.decisions[at(branch.index)];
      const std::string node = id("d", branch.index);
      const std::string condition = wrapped(expressionText(model_, decision.condition), true);
      const std::string doc = plainDoc(decision.doc);
      graph.node(node, "decision", doc.empty() ? condition : wrapped(doc, false) + condition,
                 ", shape=box, fontname=Courier, fontsize=9, margin=\"0.18,0.06\"");
      connect(graph, from, node, label);
      addBranch(graph, node, "yes", decision.then, own);
      from = node;
      label = "no";
      branch = decision.otherwise;
    }
    const std::string leaf = graph.freshId();
    if (branch.kind == Branch::Kind::state)
      addState(graph, leaf, branch.index, branch.index == own ? "state own" : "state");
    else
      graph.node(leaf, "stay",
                 branch.kind == Branch::Kind::stay ? "stay" : "the decision of the state",
                 ", shape=plaintext");
    connect(graph, from, leaf, label);
  }

  static void connect(Graph& graph, const std::string& from, const std::string& to,
                      const std::string& label) {
    graph.edge(from, to, "decides", label.empty() ? "" : ", label=\" " + label + " \"");
  }

  const Model& model_;
  const Usage& usage_;
  const Links& links_;
};

}  // namespace

Charts describeCharts(const Model& model, const Usage& usage, const Links& links) {
  return Describer(model, usage, links).run();
}

}  // namespace xabsl::documentation
