#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <vector>

#include "observer/MessageQueues.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr const char* disabled = "disabled";
constexpr const char* queues[][2] = {{"simulatedRobot", "allSimulatedRobots"},
                                     {"physicalRobot", "allPhysicalRobots"}};

/// A task of the connected robots of both kinds.
struct TaskRow {
  std::string task;
  std::vector<std::string> solutions;
  std::string standard;   ///< The configuration's solution.
  std::string active[2];  ///< Empty if no process of that robot solves it.
  bool operator==(const TaskRow&) const = default;
};

std::vector<TaskRow> tasksOf(Console& console) {
  std::map<std::string, TaskRow> rows;
  std::vector<ObservedRobot*> robots;
  // The selected ones come first: a tool is connected to the first of each kind.
  for (ConsoleRobot* robot : console.selected()) robots.push_back(&robot->observed());
  for (const auto& robot : console.session().robots())
    if (std::ranges::find(robots, &robot->observed()) == robots.end())
      robots.push_back(&robot->observed());
  for (int kind = 0; kind < 2; ++kind) {
    const auto ends =
        robotsOf(kind == 0 ? QueueName::toSimulatedRobot : QueueName::toPhysicalRobot, robots);
    if (ends.empty()) continue;
    const auto processes = ends.front()->processes();
    if (!processes) continue;
    for (const ProcessDescription& process : **processes)
      for (const TaskDescription& task : process.tasks) {
        TaskRow& row = rows[task.name];
        row.task = task.name;
        row.active[kind] = task.active.empty() ? disabled : task.active;
        row.solutions.clear();
        for (const SolutionDescription& solution : task.solutions)
          row.solutions.push_back(solution.name);
      }
  }
  for (const auto& choice : console.session().match().configuration().solutions)
    if (const auto row = rows.find(choice.task); row != rows.end())
      row->second.standard = choice.solution;
  std::vector<TaskRow> list;
  for (auto& [name, row] : rows) list.push_back(std::move(row));
  return list;
}

/// Report J.2.3: which solution of each task runs, in the connected simulated robot and in the
/// connected physical one. Settings have names.
class Solutions : public Dialog {
 public:
  explicit Solutions(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* top = new QHBoxLayout;
    setting_ = makeControl<QComboBox>("setting", "Choosing a setting sends all its solutions");
    top->addWidget(setting_, 1);
    const auto button = [&](const char* name, const char* text, const char* help, auto pressed) {
      auto* made = makeControl<QPushButton>(name, help, text);
      QObject::connect(made, &QPushButton::clicked, this, pressed);
      top->addWidget(made);
    };
    button("new", "New…", "Keeps what runs now as a setting",
           [this] { keep(QInputDialog::getText(this, "New setting", "Name:")); });
    button("delete", "Delete", "Forgets the setting", [this] {
      settings_.remove(setting_->currentText());
      showSettings({});
    });
    layout->addLayout(top);
    auto* second = new QHBoxLayout;
    filter_ = makeControl<QLineEdit>("filter", "Lists only tasks whose names hold these letters");
    filter_->setPlaceholderText("Some letters of a task");
    filter_->setClearButtonEnabled(true);
    QObject::connect(filter_, &QLineEdit::textChanged, this, [this] { filter(); });
    second->addWidget(filter_);
    all_ = makeControl<QCheckBox>(
        "all", "Switches the solution of all robots of the kind, not of the connected one",
        "All robots");
    second->addWidget(all_);
    layout->addLayout(second);
    tree_ = new QTreeWidget;
    tree_->setObjectName("tasks");
    tree_->setColumnCount(3);
    tree_->setHeaderLabels({"Task", "Simulated", "Physical"});
    tree_->setRootIsDecorated(false);
    tree_->setUniformRowHeights(true);
    tree_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    layout->addWidget(tree_);
    QObject::connect(setting_, &QComboBox::activated, this, [this](int) { send(); });
    showSettings({});
  }

  QJsonObject settings() const override {
    return {{"settings", settings_}, {"all", all_->isChecked()}};
  }
  void restore(const QJsonObject& settings) override {
    settings_ = settings["settings"].toObject();
    all_->setChecked(settings["all"].toBool());
    showSettings({});
  }
  void refresh() override {
    if (asked_) return;
    const SessionStatus status = session().status();
    std::vector<std::string> connected;
    for (const RobotInfo& robot : status.robots)
      if (robot.selected) connected.push_back(robot.name);
    // While time passes, nobody switches solutions but by commands, which are seen a second later.
    if (connected == connected_ && status.beginnings == beginnings_ && clock_.isValid() &&
        clock_.elapsed() < 1000)
      return;
    connected_ = connected;
    beginnings_ = status.beginnings;
    clock_.start();
    asked_ = true;
    session().ask(this, tasksOf, [this](std::vector<TaskRow>& rows) {
      asked_ = false;
      showRows(std::move(rows));
    });
  }
  /// Keeps what runs now as a setting.
  void keep(const QString& name) {
    if (name.trimmed().isEmpty()) return;
    QJsonObject setting;
    for (const TaskRow& row : rows_)
      if (!row.active[0].empty())
        setting[QString::fromStdString(row.task)] = QString::fromStdString(row.active[0]);
    settings_[name] = setting;
    showSettings(name);
  }

 private:
  void showSettings(const QString& current) {
    setting_->clear();
    setting_->addItem("default");
    for (const QString& name : settings_.keys()) setting_->addItem(name);
    setting_->setCurrentText(current);
  }

  void showRows(std::vector<TaskRow> rows) {
    if (rows == rows_) return;
    for (const QComboBox* box : tree_->findChildren<QComboBox*>())
      if (box->view()->isVisible()) return;  // somebody is choosing
    rows_ = std::move(rows);
    tree_->clear();
    for (const TaskRow& row : rows_) {
      auto* item = new QTreeWidgetItem{tree_, {QString::fromStdString(row.task)}};
      for (int kind = 0; kind < 2; ++kind)
        if (!row.active[kind].empty()) tree_->setItemWidget(item, 1 + kind, boxOf(row, kind));
    }
    tree_->setColumnHidden(
        2, std::ranges::none_of(rows_, [](const TaskRow& row) { return !row.active[1].empty(); }));
    filter();
  }

  QComboBox* boxOf(const TaskRow& row, int kind) {
    auto* box = new QComboBox;
    box->setObjectName(QString::fromStdString(row.task) + (kind == 0 ? "" : ".physical"));
    box->setFocusPolicy(Qt::StrongFocus);
    const auto add = [&](const std::string& solution) {
      box->addItem(QString::fromStdString(solution) + (solution == row.standard ? " *" : ""),
                   QString::fromStdString(solution));
    };
    for (const std::string& solution : row.solutions) add(solution);
    add(disabled);
    box->setCurrentIndex(box->findData(QString::fromStdString(row.active[kind])));
    box->setToolTip("The solution that runs; * marks that of the configuration");
    QObject::connect(box, &QComboBox::activated, this, [this, box, task = row.task, kind] {
      request(kind, task, box->currentData().toString().toStdString());
    });
    return box;
  }

  void request(int kind, const std::string& task, const std::string& solution) {
    session().execute(
        std::string{"to "} + queues[kind][all_->isChecked()] + " sr " + task + " " + solution, this,
        [this](const Result<void>&) { clock_.invalidate(); });  // looks again what runs now
  }

  /// Sends all solutions of the chosen setting.
  void send() {
    const QJsonObject setting = settings_.value(setting_->currentText()).toObject();
    for (const TaskRow& row : rows_)
      for (int kind = 0; kind < 2; ++kind) {
        const std::string wanted =
            setting_->currentIndex() == 0
                ? row.standard
                : setting[QString::fromStdString(row.task)].toString().toStdString();
        if (!row.active[kind].empty() && !wanted.empty() && wanted != row.active[kind])
          request(kind, row.task, wanted);
      }
  }

  void filter() {
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
      QTreeWidgetItem* item = tree_->topLevelItem(i);
      item->setHidden(!item->text(0).contains(filter_->text(), Qt::CaseInsensitive));
    }
  }

  QComboBox* setting_;
  QLineEdit* filter_;
  QCheckBox* all_;
  QTreeWidget* tree_;
  QJsonObject settings_;  ///< By their names: solutions by tasks.
  std::vector<TaskRow> rows_;
  std::vector<std::string> connected_;
  std::uint64_t beginnings_ = 0;
  QElapsedTimer clock_;
  bool asked_ = false;
};

const RegisterDialog<Solutions> registeredSolutions{
    {.id = "solutions",
     .title = "Settings",
     .group = "Robots",
     .help = "Which solution of each task runs; settings with names",
     .report = "J.2.3",
     .place = DialogPlace::left,
     .atFirst = true}};

}  // namespace
}  // namespace gt
