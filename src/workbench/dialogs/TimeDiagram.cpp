#include <QElapsedTimer>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QSpinBox>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <deque>
#include <map>

#include "base/File.h"
#include "debug/Stopwatch.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int timesInterval = 400;  // ms
constexpr std::size_t mostSnapshots = 10000;
enum TimeColumn { module, process, mean, longest, rate, bar };
constexpr int shareRole = Qt::UserRole;

/// The stopwatches of a robot's modules at a time.
struct Snapshot {
  std::string robot;
  Time time;
  std::map<std::string, std::pair<std::string, Stopwatch>> modules;  ///< Process and watch.
};

Snapshot snapshotOf(Console& console) {
  Snapshot snapshot;
  const auto first = console.firstRobot();
  if (!first) return snapshot;
  ObservedRobot& robot = (*first)->observed();
  snapshot.robot = robot.name();
  snapshot.time = console.session().time();
  if (const auto times = robot.times())
    for (const auto& [process, known] : **times)
      for (const Stopwatch& watch : known.modules) snapshot.modules[watch.name] = {process, watch};
  return snapshot;
}

/// A bar as long as a share of the cell.
class BarDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QRect place = option.rect.adjusted(2, 3, -4, -3);
    place.setWidth(std::max(1, static_cast<int>(place.width() * index.data(shareRole).toDouble())));
    painter->fillRect(place, option.palette.color(QPalette::Highlight));
  }
};

/// An item that is sorted by numbers where there are numbers.
class ModuleItem : public QTreeWidgetItem {
 public:
  using QTreeWidgetItem::QTreeWidgetItem;
  bool operator<(const QTreeWidgetItem& other) const override {
    const int column = treeWidget()->sortColumn();
    if (column == module || column == process) return text(column) < other.text(column);
    return text(column).toDouble() < other.text(column).toDouble();
  }
};

/// Report J.3.6, E.7: how long each module takes, as the mean of its last measurements.
class TimeDiagram : public Dialog {
 public:
  explicit TimeDiagram(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* top = new QHBoxLayout;
    layout->addLayout(top);
    filter_ = makeControl<QLineEdit>("filter", "Lists only modules whose names hold these letters");
    filter_->setPlaceholderText("Some letters of a module");
    filter_->setClearButtonEnabled(true);
    QObject::connect(filter_, &QLineEdit::textChanged, this, [this] { showModules(); });
    top->addWidget(filter_, 1);
    top->addWidget(new QLabel{"Mean of"});
    count_ = makeControl<QSpinBox>("count",
                                   "Over how many measurements, at least, the mean is calculated");
    count_->setRange(2, 500);
    count_->setValue(100);
    top->addWidget(count_);
    tree_ = new QTreeWidget;
    tree_->setObjectName("modules");
    tree_->setHeaderLabels({"Module", "Process", "Mean ms", "Longest ms", "1/s", ""});
    tree_->setRootIsDecorated(false);
    tree_->setUniformRowHeights(true);
    tree_->setItemDelegateForColumn(bar, new BarDelegate{tree_});
    tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tree_->header()->setSectionResizeMode(bar, QHeaderView::Stretch);
    tree_->setSortingEnabled(true);
    tree_->sortByColumn(mean, Qt::DescendingOrder);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    layout->addWidget(tree_);
    QObject::connect(
        tree_, &QTreeWidget::customContextMenuRequested, this, [this](const QPoint& at) {
          QMenu menu;
          menu.addAction("Export as CSV…", this, [this] {
            const QString file =
                QFileDialog::getSaveFileName(this, "Export", "out/times.csv", "Tables (*.csv)");
            if (file.isEmpty()) return;
            if (const auto done = writeFile(file.toStdString(), table()); !done)
              QMessageBox::warning(this, "Export", QString::fromStdString(done.error().text()));
          });
          menu.exec(tree_->viewport()->mapToGlobal(at));
        });
  }

  QJsonObject settings() const override {
    return {{"count", count_->value()}, {"filter", filter_->text()}};
  }
  void restore(const QJsonObject& settings) override {
    count_->setValue(settings["count"].toInt(100));
    filter_->setText(settings["filter"].toString());
  }

  void refresh() override {
    const std::uint64_t version = session().version();
    if (asked_ || version == version_ || (clock_.isValid() && clock_.elapsed() < timesInterval))
      return;
    version_ = version;
    clock_.start();
    asked_ = true;
    session().ask(this, snapshotOf, [this](Snapshot& snapshot) {
      asked_ = false;
      // Another robot, or one that has begun anew.
      if (!snapshots_.empty() &&
          (snapshots_.back().robot != snapshot.robot || snapshots_.back().time > snapshot.time))
        snapshots_.clear();
      snapshots_.push_back(std::move(snapshot));
      if (snapshots_.size() > mostSnapshots) snapshots_.pop_front();
      showModules();
    });
  }

 private:
  struct Row {
    double mean = 0, rate = 0;
  };

  /// Mean and rate over at least as many measurements as were chosen, if there are so many.
  Row rowOf(const std::string& name, const Stopwatch& now) const {
    Stopwatch before;
    Time since{};
    for (auto snapshot = snapshots_.rbegin(); snapshot != snapshots_.rend(); ++snapshot) {
      const auto known = snapshot->modules.find(name);
      if (known == snapshot->modules.end()) break;
      before = known->second.second;
      since = snapshot->time;
      if (now.count - before.count >= count_->value()) break;
    }
    if (now.count == before.count) return {now.meanMs(), 0};
    const double seconds = static_cast<double>(snapshots_.back().time - since) / 1000;
    const auto times = static_cast<double>(now.count - before.count);
    return {(now.totalMs - before.totalMs) / times, seconds > 0 ? times / seconds : 0};
  }

  void showModules() {
    if (snapshots_.empty()) return;
    const Snapshot& newest = snapshots_.back();
    std::map<std::string, Row> rows;
    double longestMean = 1e-9;
    for (const auto& [name, known] : newest.modules) {
      if (!QString::fromStdString(name).contains(filter_->text(), Qt::CaseInsensitive)) continue;
      rows[name] = rowOf(name, known.second);
      longestMean = std::max(longestMean, rows[name].mean);
    }
    tree_->setSortingEnabled(false);
    for (auto item = items_.begin(); item != items_.end();) {
      if (rows.contains(item->first)) {
        ++item;
        continue;
      }
      delete item->second;
      item = items_.erase(item);
    }
    for (const auto& [name, row] : rows) {
      QTreeWidgetItem*& item = items_[name];
      if (!item) {
        item = new ModuleItem{tree_};
        item->setText(module, QString::fromStdString(name));
        for (const int column : {mean, longest, rate})
          item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
      }
      const auto& [processName, watch] = newest.modules.at(name);
      item->setText(process, QString::fromStdString(processName));
      item->setText(mean, QString::number(row.mean, 'f', 3));
      item->setText(longest, QString::number(watch.longestMs, 'f', 3));
      item->setText(rate, QString::number(row.rate, 'f', 1));
      item->setData(bar, shareRole, row.mean / longestMean);
    }
    tree_->setSortingEnabled(true);
  }

  std::string table() const {
    std::string text = "module,process,mean ms,longest ms,times a second\n";
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
      const QTreeWidgetItem& item = *tree_->topLevelItem(i);
      for (const int column : {module, process, mean, longest, rate})
        text += item.text(column).toStdString() + (column == rate ? "\n" : ",");
    }
    return text;
  }

  QLineEdit* filter_;
  QSpinBox* count_;
  QTreeWidget* tree_;
  std::map<std::string, QTreeWidgetItem*> items_;  ///< By the modules' names.
  std::deque<Snapshot> snapshots_;
  QElapsedTimer clock_;
  std::uint64_t version_ = 0;
  bool asked_ = false;
};

const RegisterDialog<TimeDiagram> registeredTimeDiagram{
    {.id = "times",
     .title = "Time diagram",
     .group = "Viewers",
     .help = "How long each of the robot's modules takes, and how often it runs",
     .report = "J.3.6, E.7",
     .place = DialogPlace::bottom}};

}  // namespace
}  // namespace gt
