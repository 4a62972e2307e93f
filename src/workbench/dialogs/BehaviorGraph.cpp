#include <QComboBox>
#include <QContextMenuEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "workbench/BehaviorTraces.h"
#include "workbench/ChartWidget.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/RobotMenu.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace gt {
namespace {

using xabsl::TraceEvent;

/// How long a state that was left and a transition stay lit, in ms of the robot's time.
constexpr double glow = 1500;
constexpr std::size_t keptTransitions = 100;

/// A call that stands in a behavior's text: from an option to an option or a basic behavior.
using Calls = std::vector<std::pair<std::string, std::string>>;

/// The calls of the behavior that robots of the session run.
Calls callsOf(Console& console) {
  Calls calls;
  const auto model = console.behavior();
  if (!model) return calls;
  const auto add = [&](const xabsl::Option& option, const xabsl::Span& actions) {
    for (const xabsl::Action& action : actions.of((*model)->actions)) {
      const auto target = static_cast<std::size_t>(action.target);
      if (action.kind == xabsl::Action::Kind::option)
        calls.emplace_back(option.name, (*model)->options[target].name);
      else if (action.kind == xabsl::Action::Kind::behavior)
        calls.emplace_back(option.name, (*model)->behaviors[target].name);
    }
  };
  for (const xabsl::Option& option : (*model)->options) {
    add(option, option.commonActions);
    for (const int state : option.states)
      add(option, (*model)->states[static_cast<std::size_t>(state)].actions);
  }
  std::ranges::sort(calls);
  calls.erase(std::unique(calls.begin(), calls.end()), calls.end());
  return calls;
}

/// A transition that happened, and why.
struct Transition {
  double time = 0;  ///< ms
  int from = -1, to = -1;
  std::string why;
};

/// What is known of an option from traces.
struct OptionRecord {
  int state = -1;              ///< The last one,
  double seen = -1e12;         ///< and when it was active last.
  std::string now;             ///< What it decided then.
  std::map<int, double> left;  ///< When states were active last.
  std::deque<Transition> transitions;
};

/// What a robot's behavior did, cycle by cycle.
class BehaviorRecord {
 public:
  /// Returns whether the behavior is another one from now on.
  bool take(const std::string& part) {
    bool another = false;
    if (part.starts_with("xabsl")) {
      auto reading = xabsl::readTraces("trace", part);
      if (reading.traces.empty()) return false;
      trace_ = std::move(reading.traces.back());
      options_.assign(subject().model.options.size(), {});
      behaviors_.assign(subject().model.behaviors.size(), -1e12);
      calls_.clear();
      another = true;
    } else if (subject().model.options.empty() || readMore(trace_, "trace", part)) {
      return false;
    }
    xabsl::forEachCycle(trace_.events, [this](const TraceEvent* first, const TraceEvent* last) {
      takeCycle(first, last);
    });
    trace_.events.clear();
    return another;
  }
  void clear() { *this = {}; }

  const xabsl::TraceSubject& subject() const { return trace_.subject; }
  const std::vector<OptionRecord>& options() const { return options_; }
  double now() const { return now_; }
  double behaviorSeen(std::size_t behavior) const { return behaviors_[behavior]; }
  /// All calls so far, as names of the caller and the called.
  const std::set<std::pair<std::string, std::string>>& calls() const { return calls_; }

 private:
  void takeCycle(const TraceEvent* first, const TraceEvent* last) {
    if (first->value < now_) forgetLater(first->value);
    now_ = first->value;
    std::vector<std::string> path;
    for (const TraceEvent* event = first; event != last;) {
      const TraceEvent* end = event + 1;
      const auto begins = [](const TraceEvent& e) {
        return e.kind == TraceEvent::Kind::option || e.kind == TraceEvent::Kind::behavior;
      };
      while (end != last && !begins(*end)) ++end;
      if (begins(*event)) takeBlock(event, end, path);
      event = end;
    }
  }
  /// All that an option, or a basic behavior, did in a cycle.
  void takeBlock(const TraceEvent* first, const TraceEvent* last, std::vector<std::string>& path) {
    const auto& model = subject().model;
    const auto index = static_cast<std::size_t>(first->index);
    const bool isOption = first->kind == TraceEvent::Kind::option;
    const std::string& name = isOption ? model.options[index].name : model.behaviors[index].name;
    constexpr double deepest = 1000;
    path.resize(
        std::min(path.size(), static_cast<std::size_t>(std::clamp(first->value, 0.0, deepest))));
    if (!path.empty()) calls_.emplace(path.back(), name);
    path.push_back(name);
    if (!isOption) {
      behaviors_[index] = now_;
      return;
    }
    OptionRecord& option = options_[index];
    int from = -1;
    for (const TraceEvent* event = first; event != last; ++event) {
      if (event->kind == TraceEvent::Kind::change) from = event->index;
      if (event->kind == TraceEvent::Kind::state) option.state = event->index;
    }
    option.seen = now_;
    option.left[option.state] = now_;
    option.now = xabsl::printCycle(subject(), first, last, true);
    if (from < 0) return;
    option.transitions.push_back(
        {now_, from, option.state, xabsl::printCycle(subject(), first, last)});
    if (option.transitions.size() > keptTransitions) option.transitions.pop_front();
  }
  /// The robot has gone back in time.
  void forgetLater(double now) {
    for (OptionRecord& option : options_) {
      std::erase_if(option.transitions, [&](const Transition& t) { return t.time >= now; });
      std::erase_if(option.left, [&](const auto& left) { return left.second >= now; });
      if (option.seen >= now) option.seen = -1e12;
    }
    for (double& seen : behaviors_)
      if (seen >= now) seen = -1e12;
  }

  xabsl::Trace trace_;
  std::vector<OptionRecord> options_;
  std::vector<double> behaviors_;
  std::set<std::pair<std::string, std::string>> calls_;
  double now_ = 0;
};

/// The option graph and the state machine of one of its options, whose active parts light up.
class BehaviorGraph : public Dialog {
 public:
  explicit BehaviorGraph(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    row->addWidget(new QLabel{"Option"});
    option_ = makeControl<QComboBox>(
        "option", "Whose states are shown; a click in the graph of options chooses one, too");
    QObject::connect(option_, &QComboBox::currentIndexChanged, this, [this] { showStates(); });
    row->addWidget(option_, 1);
    onlyActive_ = makeControl<QToolButton>(
        "onlyActive",
        "Shows only the options that were active so far; otherwise all that "
        "the behavior's text calls");
    onlyActive_->setText("Active so far");
    onlyActive_->setCheckable(true);
    onlyActive_->setChecked(true);
    QObject::connect(onlyActive_, &QToolButton::toggled, this, [this] { showOptions(); });
    row->addWidget(onlyActive_);
    auto* parts = new QSplitter{Qt::Vertical};
    layout->addWidget(parts, 1);
    auto* charts = new QSplitter{Qt::Horizontal};
    parts->addWidget(charts);
    options_ = addChart(*charts, "options",
                        "Options and basic behaviors; those that are active "
                        "are lit; a click chooses an option");
    options_->clicked = [this](int node) { chooseOption(node); };
    states_ = addChart(*charts, "states",
                       "The states of the option; the active one is lit; a "
                       "click shows what is decided in one, and why it began");
    states_->clicked = [this](int node) { chooseState(node); };
    why_ = new QPlainTextEdit;
    why_->setObjectName("why");
    why_->setReadOnly(true);
    why_->setLineWrapMode(QPlainTextEdit::NoWrap);
    why_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    why_->setPlaceholderText("A click on a state shows its decisions, and why it began lately");
    parts->addWidget(why_);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 1);
    parts->setSizes({300, 120});
  }

  QJsonObject settings() const override {
    return {{"robot", QString::fromStdString(robot_)},
            {"option", option_->currentText()},
            {"onlyActive", onlyActive_->isChecked()}};
  }
  void restore(const QJsonObject& settings) override {
    wanted_ = settings["option"].toString();
    onlyActive_->setChecked(settings["onlyActive"].toBool(true));
    setRobot(settings["robot"].toString().toStdString());
  }

  void refresh() override {
    if (traces_.beganAnew()) record_.clear();
    const auto parts = traces_.takeParts();
    if (parts.empty()) return;
    bool another = false;
    for (const std::string& part : parts) another |= record_.take(part);
    if (another) showBehavior();
    if (record_.calls().size() != calls_ && onlyActive_->isChecked()) showOptions();
    light();
    if (state_ >= 0) showWhy();
  }

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override {
    QMenu menu;
    addRobotMenu(menu, session(), robot_, [this](const std::string& robot) { setRobot(robot); });
    menu.exec(event->globalPos());
  }

 private:
  static ChartWidget* addChart(QSplitter& parts, const char* name, const char* help) {
    auto* chart = new ChartWidget;
    chart->setObjectName(name);
    chart->setToolTip(help);
    parts.addWidget(chart);
    return chart;
  }
  const xabsl::TraceSubject& subject() const { return record_.subject(); }

  void setRobot(const std::string& robot) {
    robot_ = robot;
    record_.clear();
    traces_.follow(robot);
  }

  /// Another behavior than before.
  void showBehavior() {
    if (wanted_.isEmpty()) wanted_ = option_->currentText();
    const QSignalBlocker quiet{option_};
    option_->clear();
    for (const xabsl::Option& option : subject().model.options)
      option_->addItem(QString::fromStdString(option.name));
    const int index = option_->findText(wanted_);
    option_->setCurrentIndex(std::max(0, index));
    wanted_.clear();
    session().ask(this, callsOf, [this](Calls& calls) {
      written_ = std::move(calls);
      showOptions();
    });
    showOptions();
    showStates();
  }

  /// Nodes are options first, then basic behaviors: those that are called.
  void showOptions() {
    calls_ = record_.calls().size();
    std::set<std::pair<std::string, std::string>> calls = record_.calls();
    if (!onlyActive_->isChecked()) calls.insert(written_.begin(), written_.end());
    ChartPlan plan{{}, {}, true};
    names_.clear();
    const auto node = [&](const std::string& name) {
      const auto known = names_.find(name);
      if (known != names_.end()) return known->second;
      const bool isOption = xabsl::indexOf(subject().model.options, name) >= 0;
      const QString shown = QString::fromStdString(name);
      plan.nodes.push_back({shown, isOption ? ChartPlan::Shape::box : ChartPlan::Shape::rounded,
                            (isOption ? "Option " : "Basic behavior ") + shown});
      return names_[name] = static_cast<int>(plan.nodes.size()) - 1;
    };
    for (std::size_t i = 0; i < record_.options().size(); ++i)
      if (record_.options()[i].state >= 0) node(subject().model.options[i].name);
    for (const auto& [caller, callee] : calls) {
      const int from = node(caller);
      plan.edges.push_back({from, node(callee)});
    }
    options_->showChart(std::move(plan));
  }

  void findTargets(const xabsl::Branch& branch, std::set<int>& targets) const {
    if (branch.kind == xabsl::Branch::Kind::state) targets.insert(branch.index);
    if (branch.kind != xabsl::Branch::Kind::decision) return;
    const auto& decision = subject().model.decisions[static_cast<std::size_t>(branch.index)];
    findTargets(decision.then, targets);
    findTargets(decision.otherwise, targets);
  }

  /// Nodes are where the option begins, its states, and its common decision if it has one.
  void showStates() {
    state_ = -1;
    const int index = option_->currentIndex();
    const auto& model = subject().model;
    if (index < 0 || static_cast<std::size_t>(index) >= model.options.size()) return;
    const xabsl::Option& option = model.options[static_cast<std::size_t>(index)];
    ChartPlan plan;
    plan.nodes.push_back({{}, ChartPlan::Shape::point, "Where the option begins"});
    const auto nodeOf = [&](int state) { return 1 + state - option.states.first; };
    for (const int i : option.states) {
      const xabsl::State& state = model.states[static_cast<std::size_t>(i)];
      plan.nodes.push_back(
          {QString::fromStdString(state.name),
           state.target ? ChartPlan::Shape::doubleEllipse : ChartPlan::Shape::ellipse,
           QString::fromStdString(state.name) + (state.target ? " (target state)" : "")});
    }
    if (option.initialState >= 0) plan.edges.push_back({0, nodeOf(option.initialState)});
    const auto connect = [&](int from, const xabsl::Branch& branch) {
      std::set<int> targets;
      findTargets(branch, targets);
      for (const int target : targets)
        if (nodeOf(target) != from) plan.edges.push_back({from, nodeOf(target)});
    };
    for (const int i : option.states)
      connect(nodeOf(i), model.states[static_cast<std::size_t>(i)].decision);
    if (option.commonDecision.kind == xabsl::Branch::Kind::decision) {
      plan.nodes.push_back({"in each state", ChartPlan::Shape::dashed,
                            "The common decision, which comes first in each state"});
      connect(static_cast<int>(plan.nodes.size()) - 1, option.commonDecision);
    }
    states_->showChart(std::move(plan));
    why_->clear();
  }

  double lightOf(double seen) const {
    return std::clamp(1 - (record_.now() - seen) / glow, 0.0, 1.0);
  }
  /// What is not active now is dimmer than what is.
  double lightOfLeft(double seen) const {
    constexpr double dim = 0.6;
    return seen == record_.now() ? 1 : dim * lightOf(seen);
  }

  void light() {
    std::vector<double> nodes(names_.size());
    for (const auto& [name, node] : names_) {
      const auto& model = subject().model;
      const int option = xabsl::indexOf(model.options, name);
      const int behavior = xabsl::indexOf(model.behaviors, name);
      const double seen = option >= 0     ? record_.options()[static_cast<std::size_t>(option)].seen
                          : behavior >= 0 ? record_.behaviorSeen(static_cast<std::size_t>(behavior))
                                          : -1e12;
      nodes[static_cast<std::size_t>(node)] = lightOfLeft(seen);
    }
    options_->light(std::move(nodes), {});
    lightStates();
  }

  void lightStates() {
    const int index = option_->currentIndex();
    if (index < 0 || static_cast<std::size_t>(index) >= record_.options().size()) return;
    const OptionRecord& option = record_.options()[static_cast<std::size_t>(index)];
    const xabsl::Option& described = subject().model.options[static_cast<std::size_t>(index)];
    const ChartPlan& plan = states_->plan();
    std::vector<double> nodes(plan.nodes.size()), edges(plan.edges.size());
    const auto nodeOf = [&](int state) { return 1 + state - described.states.first; };
    for (const auto& [state, seen] : option.left)
      if (const auto node = static_cast<std::size_t>(nodeOf(state)); node < nodes.size())
        nodes[node] = lightOfLeft(seen);
    const int common = static_cast<int>(plan.nodes.size()) - 1;
    for (const Transition& transition : option.transitions)
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const ChartPlan::Edge& edge = plan.edges[i];
        const bool own = edge.from == nodeOf(transition.from);
        // By the common decision if the state itself has no such transition.
        const bool byCommon =
            edge.from == common && described.commonDecision.kind == xabsl::Branch::Kind::decision &&
            std::ranges::find(plan.edges,
                              ChartPlan::Edge{nodeOf(transition.from), nodeOf(transition.to)}) ==
                plan.edges.end();
        if ((own || byCommon) && edge.to == nodeOf(transition.to))
          edges[i] = std::max(edges[i], lightOf(transition.time));
      }
    states_->light(std::move(nodes), std::move(edges));
  }

  void chooseOption(int node) {
    for (const auto& [name, known] : names_)
      if (known == node && option_->findText(QString::fromStdString(name)) >= 0) {
        option_->setCurrentText(QString::fromStdString(name));
        options_->select(node);
        lightStates();
      }
  }
  void chooseState(int node) {
    const int index = option_->currentIndex();
    if (index < 0 || static_cast<std::size_t>(index) >= subject().model.options.size()) return;
    const xabsl::Span& states = subject().model.options[static_cast<std::size_t>(index)].states;
    if (node < 1 || node > states.count) return;
    state_ = states.first + node - 1;
    states_->select(node);
    showWhy();
  }

  /// The text of a decision tree, indented.
  std::string treeText(const xabsl::Branch& branch, std::size_t depth) const {
    const std::string begin(2 * depth, ' ');
    constexpr std::size_t deepest = 100;
    if (branch.kind == xabsl::Branch::Kind::state)
      return begin + "-> " + subject().state(branch.index).name + "\n";
    if (branch.kind != xabsl::Branch::Kind::decision || depth > deepest)
      return begin +
             (branch.kind == xabsl::Branch::Kind::stay ? "stay\n" : "as the state decides\n");
    const auto index = static_cast<std::size_t>(branch.index);
    const auto& decision = subject().model.decisions[index];
    const auto& condition = subject().conditions[index];
    return begin + "if " + condition.text + "  (" + subject().place(condition.location) + ")\n" +
           treeText(decision.then, depth + 1) + begin + "else\n" +
           treeText(decision.otherwise, depth + 1);
  }

  void showWhy() {
    const auto index = static_cast<std::size_t>(option_->currentIndex());
    if (index >= record_.options().size()) return;
    const OptionRecord& option = record_.options()[index];
    const xabsl::State& state = subject().state(state_);
    std::string text = "Decisions of " + state.name + ":\n";
    const auto& common = subject().model.options[index].commonDecision;
    if (common.kind == xabsl::Branch::Kind::decision) text += treeText(common, 1);
    text += treeText(state.decision, 1);
    if (option.seen == record_.now() && option.state == state_)
      text += "\nIt is active. What was asked in the last cycle:\n" + option.now;
    int shown = 0;
    constexpr int most = 5;
    for (auto t = option.transitions.rbegin(); t != option.transitions.rend() && shown < most; ++t)
      if (t->to == state_) {
        if (shown++ == 0) text += "\nWhy it began lately:\n";
        text += QString::number(t->time / 1000, 'f', 2).toStdString() + " s\n" + t->why;
      }
    const QString shownText = QString::fromStdString(text);
    if (shownText == why_->toPlainText()) return;
    const int place = why_->verticalScrollBar()->value();
    why_->setPlainText(shownText);
    why_->verticalScrollBar()->setValue(place);
  }

  QComboBox* option_;
  QToolButton* onlyActive_;
  ChartWidget* options_;
  ChartWidget* states_;
  QPlainTextEdit* why_;
  BehaviorRecord record_;
  Calls written_;                     ///< In the behavior's text.
  std::map<std::string, int> names_;  ///< Nodes of the graph of options.
  std::size_t calls_ = 0;             ///< Of which the graph was made.
  int state_ = -1;                    ///< That was chosen.
  QString wanted_;                    ///< An option, as soon as there is a behavior.
  std::string robot_;                 ///< Empty: the connected one.
  BehaviorTraces traces_{session()};
};

const RegisterDialog<BehaviorGraph> registeredBehaviorGraph{
    {.id = "behaviorGraph",
     .title = "Behavior graph",
     .group = "Viewers",
     .help = "Options and states as a picture, lit while they are active; a click shows decisions",
     .report = "J.5.1",
     .place = DialogPlace::center,
     .several = true}};

}  // namespace
}  // namespace gt
