#include <QApplication>
#include <QClipboard>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QJsonArray>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <set>

#include "streams/Config.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int valuesInterval = 200;       // ms
constexpr std::size_t mostFields = 2000;  // of a representation
enum Role { pathRole = Qt::UserRole, groupRole };

/// A line of the tree: something below a group, which is a representation, a solution, or a part of
/// the scene.
struct Line {
  std::string group, path, name, value, help;
  bool canBeSet = true;
};
struct Lines {
  std::string robot;
  std::vector<std::string> groups;  ///< All that there are: PART/NAME.
  std::vector<Line> lines;          ///< Of the groups that were asked for.
};

constexpr const char* representationPart = "Representations";
constexpr const char* parameterPart = "Parameters";
constexpr const char* scenePart = "Scene";

void addFields(ObservedRobot& robot, const std::string& name, std::vector<Line>& lines) {
  const auto paths = robot.paths(name);
  const auto value = robot.value(name);
  if (!paths || !value) return;
  for (const std::string& path : *paths) {
    if (lines.size() >= mostFields) return;
    const std::string rest = path.substr(name.size() + 1);
    if (auto text = detail::getByPath(*value, rest))
      lines.push_back(
          {std::string{representationPart} + "/" + name, path, rest, std::move(*text), {}});
  }
}

Lines linesOf(Console& console, const std::set<std::string>& open) {
  Lines found;
  if (const auto first = console.firstRobot()) {
    ObservedRobot& robot = (*first)->observed();
    found.robot = robot.name();
    for (const std::string& name : robot.representations()) {
      found.groups.push_back(std::string{representationPart} + "/" + name);
      if (open.contains(found.groups.back())) addFields(robot, name, found.lines);
    }
    if (const auto processes = robot.processes())
      for (const ProcessDescription& process : **processes)
        for (const TaskDescription& task : process.tasks)
          for (const SolutionDescription& solution : task.solutions) {
            if (solution.parameters.empty()) continue;
            const std::string name = task.name + "." + solution.name;
            found.groups.push_back(std::string{parameterPart} + "/" + name);
            if (!open.contains(found.groups.back())) continue;
            for (const ParameterDescription& p : solution.parameters)
              found.lines.push_back({found.groups.back(), name + "." + p.path, p.path, p.value,
                                     (p.unit.empty() ? "" : "[" + p.unit + "] ") + p.doc});
          }
  }
  SceneTree& tree = console.session().tree();
  for (const SceneTree::Object& object : tree.list("")) {
    const std::size_t slash = object.path.find('/');
    const std::string group = std::string{scenePart} + "/" + object.path.substr(0, slash);
    if (found.groups.empty() || found.groups.back() != group) found.groups.push_back(group);
    if (!open.contains(group)) continue;
    if (auto value = tree.get(object.path))
      found.lines.push_back(
          {group, object.path,
           slash == std::string::npos ? object.path : object.path.substr(slash + 1),
           std::move(*value), std::string{object.help}, object.canBeSet});
  }
  return found;
}

/// Hands the paths of lines over to whoever they are dropped on, such as plots.
class PathTree : public QTreeWidget {
 public:
  PathTree() {
    setDragEnabled(true);
    setDragDropMode(DragOnly);
  }

 protected:
  QMimeData* mimeData(const QList<QTreeWidgetItem*>& items) const override {
    QStringList paths;
    for (const QTreeWidgetItem* item : items) paths << item->data(0, pathRole).toString();
    auto* dragged = new QMimeData;
    dragged->setText(paths.join("\n"));
    return dragged;
  }
};

/// All values of the connected robot and of the scene, as they change; edited in place (report 5.2,
/// E.2, J.7.1).
class ValueTree : public Dialog {
 public:
  explicit ValueTree(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    filter_ = makeControl<QLineEdit>("filter", "Lists only values whose names hold these letters");
    filter_->setPlaceholderText("Some letters of a name");
    filter_->setClearButtonEnabled(true);
    layout->addWidget(filter_);
    tree_ = new PathTree;
    tree_->setObjectName("tree");
    tree_->setColumnCount(2);
    tree_->setHeaderLabels({"Name", "Value"});
    tree_->header()->setSectionResizeMode(0, QHeaderView::Interactive);
    tree_->header()->resizeSection(0, 200);
    tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->setUniformRowHeights(true);
    tree_->setToolTip("A double click changes a value; it can be dragged onto a plot");
    layout->addWidget(tree_);
    QObject::connect(filter_, &QLineEdit::textChanged, this, [this] { filter(); });
    QObject::connect(tree_, &QTreeWidget::itemDoubleClicked, this,
                     [this](QTreeWidgetItem* item, int) {
                       if (item->flags() & Qt::ItemIsEditable) tree_->editItem(item, 1);
                     });
    QObject::connect(tree_, &QTreeWidget::itemChanged, this,
                     [this](QTreeWidgetItem* item, int column) {
                       if (column == 1) set(item->data(0, pathRole).toString(), item->text(1));
                     });
    QObject::connect(tree_, &QTreeWidget::itemExpanded, this, [this] { clock_.invalidate(); });
    QObject::connect(tree_, &QTreeWidget::customContextMenuRequested, this,
                     [this](const QPoint& at) { showMenu(at); });
  }

  QJsonObject settings() const override {
    QJsonArray open;
    for (const std::string& group : openGroups()) open.append(QString::fromStdString(group));
    return {{"open", open}};
  }
  void restore(const QJsonObject& settings) override {
    for (const QJsonValue group : settings["open"].toArray())
      toOpen_.insert(group.toString().toStdString());
    for (const auto& [group, item] : groups_)
      if (toOpen_.contains(group)) item->setExpanded(true);
  }

  void refresh() override {
    const std::uint64_t version = session().version();
    if (asked_ || (clock_.isValid() && (version == version_ || clock_.elapsed() < valuesInterval)))
      return;
    // Who edits a value is not disturbed.
    if (const QWidget* focus = QApplication::focusWidget();
        focus && focus != tree_ && tree_->isAncestorOf(focus))
      return;
    version_ = version;
    clock_.start();
    asked_ = true;
    session().ask(
        this, [open = openGroups()](Console& console) { return linesOf(console, open); },
        [this](const Lines& lines) { showLines(lines); });
  }

 private:
  std::set<std::string> openGroups() const {
    std::set<std::string> open = toOpen_;
    for (const auto& [group, item] : groups_)
      if (item->isExpanded()) open.insert(group);
    return open;
  }

  void showLines(const Lines& found) {
    asked_ = false;
    const QSignalBlocker quiet{tree_};
    if (robot_ != found.robot || known_ != found.groups) {
      for (const std::string& group : openGroups()) toOpen_.insert(group);
      robot_ = found.robot;
      known_ = found.groups;
      showGroups();
    }
    for (const Line& line : found.lines) showLine(line);
    filter();
  }

  void showGroups() {
    tree_->clear();
    groups_.clear();
    items_.clear();
    for (const char* part : {representationPart, parameterPart, scenePart}) {
      auto* top = new QTreeWidgetItem{tree_, {part}};
      const QString prefix = QString{part} + "/";
      for (const std::string& name : known_) {
        const QString group = QString::fromStdString(name);
        if (!group.startsWith(prefix)) continue;
        auto* item = new QTreeWidgetItem{top, {group.mid(prefix.size())}};
        item->setChildIndicatorPolicy(QTreeWidgetItem::ShowIndicator);
        item->setData(0, groupRole, group);
        groups_[name] = item;
        if (toOpen_.contains(name)) item->setExpanded(true);
      }
      top->setExpanded(true);
    }
    toOpen_.clear();
  }

  void showLine(const Line& line) {
    const auto group = groups_.find(line.group);
    if (group == groups_.end()) return;
    QTreeWidgetItem*& item = items_[line.path];
    if (!item) {
      item = new QTreeWidgetItem{group->second, {QString::fromStdString(line.name)}};
      item->setData(0, pathRole, QString::fromStdString(line.path));
      item->setToolTip(0, QString::fromStdString(line.help));
      item->setToolTip(1, QString::fromStdString(line.help));
      if (line.canBeSet) item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
    const QString value = QString::fromStdString(line.value);
    if (item->text(1) != value) item->setText(1, value);
  }

  void filter() {
    const QString letters = filter_->text();
    for (const auto& [name, group] : groups_) {
      const bool whole = group->text(0).contains(letters, Qt::CaseInsensitive);
      bool any = false;
      for (int i = 0; i < group->childCount(); ++i) {
        const bool shown = whole || group->child(i)->text(0).contains(letters, Qt::CaseInsensitive);
        group->child(i)->setHidden(!shown);
        any = any || shown;
      }
      group->setHidden(!whole && !any);
    }
  }

  void set(const QString& path, const QString& value) {
    session().execute("set " + path.toStdString() + " " + value.toStdString());
    clock_.invalidate();
  }

  void showMenu(const QPoint& at) {
    const QTreeWidgetItem* item = tree_->itemAt(at);
    const QString path = item ? item->data(0, pathRole).toString() : QString{};
    if (path.isEmpty()) return;
    QMenu menu;
    menu.addAction("Copy the path", this, [path] { QApplication::clipboard()->setText(path); });
    if (item->parent()->data(0, groupRole).toString().startsWith(representationPart)) {
      menu.addAction("Hold this value", this,
                     [this, path, value = item->text(1)] { hold(path, value, ValueMode::hold); });
      menu.addAction("Release it", this, [this, path] { hold(path, {}, ValueMode::release); });
    }
    menu.exec(tree_->viewport()->mapToGlobal(at));
  }

  /// A value that is held is seen by all modules that run after the one that provides it.
  void hold(const QString& path, const QString& value, ValueMode mode) {
    session().change(
        [path = path.toStdString(), value = value.toStdString(), mode](Console& console) {
          const auto done = console.forEachRobot(
              [&](ConsoleRobot& robot) { return robot.observed().set(path, value, mode); });
          if (!done) console.print("error: " + done.error().text());
        });
  }

  QLineEdit* filter_;
  QTreeWidget* tree_;
  std::map<std::string, QTreeWidgetItem*> groups_, items_;  ///< Items by their paths.
  std::vector<std::string> known_;
  std::set<std::string> toOpen_;
  std::string robot_;
  QElapsedTimer clock_;
  std::uint64_t version_ = 0;
  bool asked_ = false;
};

const RegisterDialog<ValueTree> registeredValueTree{
    {.id = "values",
     .title = "Values",
     .group = "Robots",
     .help = "All representations, parameters and objects of the scene; edited in place",
     .report = "5.2, E.2, J.7.1",
     .place = DialogPlace::left,
     .atFirst = true}};

}  // namespace
}  // namespace gt
