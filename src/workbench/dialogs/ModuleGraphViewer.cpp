#include <QContextMenuEvent>
#include <QElapsedTimer>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPainterPath>
#include <QScrollArea>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <optional>

#include "framework/SolutionTable.h"
#include "workbench/Dialog.h"
#include "workbench/RobotMenu.h"

namespace gt {
namespace {

constexpr int taskHeight = 22, taskWidth = 190, solutionWidth = 180, timeWidth = 70;
constexpr int arcsAt = taskWidth + solutionWidth + timeWidth;
constexpr int graphInterval = 1000;  // ms
constexpr double slowMs = 2;         ///< A module that takes so long is shown in full color.

/// A task of a process, with what its solution reads and provides.
struct TaskNode {
  std::string process, name, active;
  std::vector<std::string> solutions, inputs, outputs;
  double ms = 0;  ///< A run, lately.
};

/// A representation that one task provides and another reads, by their numbers.
struct Edge {
  std::size_t from, to;
  std::string representation;
};

struct Graph {
  std::string robot{}, fault{};
  std::vector<TaskNode> tasks{};
  std::vector<Edge> edges{};
};

Graph graphOf(Console& console, const std::string& wanted) {
  Graph graph;
  const auto selected = console.selected();
  ConsoleRobot* const robot = !wanted.empty()    ? console.session().find(wanted)
                              : selected.empty() ? nullptr
                                                 : selected.front();
  if (!robot) return {.fault = "There is no robot " + wanted + "."};
  graph.robot = robot->name();
  const auto processes = robot->observed().processes();
  if (!processes) return {.fault = processes.error().text()};
  std::map<std::string, std::vector<std::size_t>> providers;
  for (const ProcessDescription& process : **processes)
    for (const TaskDescription& task : process.tasks) {
      TaskNode node{process.process, task.name, task.active, {}, {}, task.outputs};
      for (const SolutionDescription& solution : task.solutions) {
        node.solutions.push_back(solution.name);
        if (solution.name == task.active) node.inputs = solution.inputs;
      }
      if (!node.inputs.empty() || task.active != SolutionTable::disabled)
        for (const std::string& output : task.outputs)
          providers[output].push_back(graph.tasks.size());
      graph.tasks.push_back(std::move(node));
    }
  for (std::size_t to = 0; to < graph.tasks.size(); ++to)
    for (const std::string& input : graph.tasks[to].inputs)
      for (const std::size_t from : providers[input])
        if (from != to) graph.edges.push_back({from, to, input});
  if (const auto times = robot->observed().times())
    for (const auto& [process, known] : **times)
      for (const Stopwatch& watch : known.modules)
        for (TaskNode& task : graph.tasks)
          if (task.process == process && task.name == watch.name) task.ms = watch.lastMs;
  return graph;
}

QString list(const std::vector<std::string>& names) {
  QStringList all;
  for (const std::string& name : names) all << QString::fromStdString(name);
  return all.isEmpty() ? "nothing" : all.join(", ");
}

/// Tasks in the order in which they run, each in a row, and an arc from each to those that read
/// what it provides.
class GraphWidget : public QWidget {
 public:
  GraphWidget() {
    setObjectName("graph");
    setMouseTracking(true);
  }
  void show(Graph graph) {
    graph_ = std::move(graph);
    if (marked_ && *marked_ >= graph_.tasks.size()) marked_.reset();
    setMinimumSize(arcsAt + 160, y(graph_.tasks.size()) + taskHeight);
    update();
  }
  const Graph& graph() const { return graph_; }
  std::function<void(const TaskNode&, const QPoint& global)> clicked;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    const std::string* process = nullptr;
    for (std::size_t i = 0; i < graph_.tasks.size(); ++i) {
      const TaskNode& task = graph_.tasks[i];
      if (!process || *process != task.process) paintProcess(painter, i);
      process = &task.process;
      paintTask(painter, i);
    }
    for (const Edge& edge : graph_.edges)
      if (!marked_) paintArc(painter, edge, faint(palette().color(QPalette::WindowText)), 1);
    if (!marked_) return;
    for (const Edge& edge : graph_.edges) {
      if (edge.from == *marked_) paintArc(painter, edge, QColor{0xe0, 0x80, 0x10}, 2);
      if (edge.to == *marked_) paintArc(painter, edge, QColor{0x30, 0x80, 0xe0}, 2);
    }
  }
  void mouseMoveEvent(QMouseEvent* event) override {
    const auto before = std::exchange(marked_, rowAt(event->pos()));
    if (before != marked_) update();
  }
  void leaveEvent(QEvent*) override {
    marked_.reset();
    update();
  }
  void mousePressEvent(QMouseEvent* event) override {
    const auto row = rowAt(event->pos());
    if (row && clicked && event->button() == Qt::LeftButton)
      clicked(graph_.tasks[*row], event->globalPosition().toPoint());
  }
  bool event(QEvent* event) override {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto row = rowAt(help->pos())) {
      const TaskNode& task = graph_.tasks[*row];
      QToolTip::showText(
          help->globalPos(),
          QString{"<b>%1</b><br>reads %2<br>provides %3"}.arg(
              QString::fromStdString(task.name), list(task.inputs), list(task.outputs)),
          this);
    }
    return true;
  }

 private:
  static QColor faint(QColor color) {
    color.setAlpha(50);
    return color;
  }
  /// Below the heading of its process.
  int y(std::size_t row) const {
    int headings = 0;
    for (std::size_t i = 0; i <= row && i < graph_.tasks.size(); ++i)
      headings += i == 0 || graph_.tasks[i].process != graph_.tasks[i - 1].process;
    return (static_cast<int>(row) + headings) * taskHeight;
  }
  std::optional<std::size_t> rowAt(const QPoint& at) const {
    for (std::size_t i = 0; i < graph_.tasks.size() && at.x() < arcsAt; ++i)
      if (at.y() >= y(i) && at.y() < y(i) + taskHeight) return i;
    return std::nullopt;
  }
  void paintProcess(QPainter& painter, std::size_t row) const {
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRect{4, y(row) - taskHeight, arcsAt, taskHeight}, Qt::AlignVCenter,
                     QString::fromStdString(graph_.tasks[row].process));
    painter.setFont(font());
  }
  void paintTask(QPainter& painter, std::size_t row) const {
    const TaskNode& task = graph_.tasks[row];
    const QRect place{0, y(row), arcsAt, taskHeight};
    const bool off = task.active.empty() || task.active == SolutionTable::disabled;
    QColor time{0xe0, 0x50, 0x30};
    time.setAlphaF(static_cast<float>(off ? 0 : std::clamp(task.ms / slowMs, 0.0, 1.0)));
    painter.fillRect(place.adjusted(2, 1, -2, -1), palette().color(QPalette::Base));
    painter.fillRect(QRect{arcsAt - timeWidth, place.y() + 1, timeWidth - 2, taskHeight - 2}, time);
    if (marked_ == row) {
      painter.setPen(palette().color(QPalette::Highlight));
      painter.drawRect(place.adjusted(2, 1, -2, -1));
    }
    painter.setPen(
        palette().color(off ? QPalette::Disabled : QPalette::Active, QPalette::WindowText));
    const auto write = [&](int x, int width, const QString& text, int align) {
      painter.drawText(QRect{x + 6, place.y(), width - 12, taskHeight}, align | Qt::AlignVCenter,
                       fontMetrics().elidedText(text, Qt::ElideRight, width - 12));
    };
    write(0, taskWidth, QString::fromStdString(task.name), Qt::AlignLeft);
    write(taskWidth, solutionWidth, QString::fromStdString(task.active), Qt::AlignLeft);
    if (!off)
      write(taskWidth + solutionWidth, timeWidth, QString{"%1 ms"}.arg(task.ms, 0, 'f', 2),
            Qt::AlignRight);
  }
  /// The farther, the wider.
  void paintArc(QPainter& painter, const Edge& edge, const QColor& color, double width) const {
    const double from = y(edge.from) + taskHeight / 2.0 + 3, to = y(edge.to) + taskHeight / 2.0 - 3;
    const double wide = std::min(16 + 0.35 * std::abs(to - from), 0.9 * (this->width() - arcsAt));
    QPainterPath path{{arcsAt + 1.0, from}};
    path.cubicTo(arcsAt + 1.3 * wide, from, arcsAt + 1.3 * wide, to, arcsAt + 6.0, to);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen{color, width});
    painter.drawPath(path);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(
        QPolygonF{{{arcsAt + 1.0, to}, {arcsAt + 7.0, to - 3}, {arcsAt + 7.0, to + 3}}});
  }

  Graph graph_;
  std::optional<std::size_t> marked_;
};

/// The running modules of a robot, with the representations that they exchange and their computing
/// times. A click switches a task's solution.
class ModuleGraphViewer : public Dialog {
 public:
  explicit ModuleGraphViewer(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    heading_ = new QLabel;
    layout->addWidget(heading_);
    graph_ = new GraphWidget;
    graph_->clicked = [this](const TaskNode& task, const QPoint& at) { choose(task, at); };
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setWidget(graph_);
    layout->addWidget(area, 1);
  }

  QJsonObject settings() const override { return {{"robot", QString::fromStdString(robot_)}}; }
  void restore(const QJsonObject& settings) override {
    setRobot(settings["robot"].toString().toStdString());
  }
  void refresh() override {
    if (asked_ || (clock_.isValid() && clock_.elapsed() < graphInterval)) return;
    clock_.start();
    asked_ = true;
    session().ask(
        this, [robot = robot_](Console& console) { return graphOf(console, robot); },
        [this](Graph& graph) {
          asked_ = false;
          heading_->setText(QString::fromStdString(
              graph.fault.empty() ? "Modules of " + graph.robot +
                                        ": blue is what the task under the pointer reads, orange "
                                        "who reads what it provides; a click switches its solution"
                                  : graph.fault));
          heading_->setWordWrap(true);
          graph_->show(std::move(graph));
        });
  }

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override {
    QMenu menu;
    addRobotMenu(menu, session(), robot_, [this](const std::string& robot) { setRobot(robot); });
    menu.exec(event->globalPos());
  }

 private:
  void setRobot(const std::string& robot) {
    robot_ = robot;
    clock_.invalidate();
  }
  void choose(const TaskNode& task, const QPoint& at) {
    QMenu menu;
    std::vector<std::string> solutions = task.solutions;
    solutions.emplace_back(SolutionTable::disabled);
    for (const std::string& solution : solutions) {
      QAction* action = menu.addAction(
          QString::fromStdString(solution), this,
          [this, robot = graph_->graph().robot, name = task.name, solution] {
            session().executeFor(robot, "sr " + name + " " + solution, this,
                                 [this](const Result<void>&) { clock_.invalidate(); });
          });
      action->setCheckable(true);
      action->setChecked(solution == task.active);
    }
    menu.exec(at);
  }

  QLabel* heading_;
  GraphWidget* graph_;
  std::string robot_;  ///< Empty: the connected one.
  QElapsedTimer clock_;
  bool asked_ = false;
};

const RegisterDialog<ModuleGraphViewer> registeredModuleGraphViewer{
    {.id = "modules",
     .title = "Module graph",
     .group = "Viewers",
     .help = "Who reads what from whom, and how long it takes; a click switches a solution"}};

}  // namespace
}  // namespace gt
