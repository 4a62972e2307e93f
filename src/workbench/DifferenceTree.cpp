#include "workbench/DifferenceTree.h"

#include <QHeaderView>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace gt {
namespace {

enum DifferenceColumn { pathColumn, differentColumn, firstColumn, largestColumn, stripColumn };

QString shortText(const std::string& value) {
  constexpr int most = 10;
  bool isNumber = false;
  const double number = QString::fromStdString(value).toDouble(&isNumber);
  return isNumber ? QString::number(number, 'g', 4) : QString::fromStdString(value).left(most);
}

void describe(QTreeWidgetItem& row, const ComparedTopic& topic) {
  row.setText(pathColumn, (topic.input ? "input " : "") + QString::fromStdString(topic.name));
  QString often = QString{"%1 of %2"}.arg(topic.different).arg(topic.compared);
  row.setText(differentColumn, topic.same() ? "same" : often);
  if (topic.onlyA + topic.onlyB > 0) {
    row.setText(firstColumn, QString{"only A %1, only B %2"}.arg(topic.onlyA).arg(topic.onlyB));
    row.setToolTip(firstColumn, "How often only one of both sides has it");
  } else if (!topic.times.empty()) {
    row.setText(firstColumn, QString{"%1 s"}.arg(inSeconds(topic.times.front()), 0, 'f', 3));
  }
}

QTreeWidgetItem* itemOf(const DifferentValue& value, std::size_t topic, std::size_t place) {
  auto* item = new QTreeWidgetItem;
  item->setText(pathColumn, QString::fromStdString(value.path.substr(value.path.find('.') + 1)));
  item->setText(differentColumn, QString::number(value.different));
  item->setText(firstColumn,
                QString{"%1 s: %2 | %3"}.arg(QString::number(inSeconds(value.first), 'f', 3),
                                             shortText(value.firstA), shortText(value.firstB)));
  item->setToolTip(firstColumn, QString::fromStdString(value.firstA) + "\n" +
                                    QString::fromStdString(value.firstB));
  if (value.largest > 0)
    item->setText(largestColumn,
                  QString{"%1 at %2 s"}.arg(QString::number(value.largest, 'g', 3),
                                            QString::number(inSeconds(value.largestAt), 'f', 2)));
  item->setData(pathColumn, Qt::UserRole,
                QVariantList{static_cast<int>(topic), static_cast<int>(place)});
  return item;
}

}  // namespace

/// Marks the times at which a row's two sides differ.
class StripDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  /// The times of a row; null if it has none.
  std::function<const std::vector<Time>*(const QModelIndex&)> times;
  Time begin, end, marked = never();

  /// Where a time is, as a share of the column's width.
  double shareOf(Time time) const {
    return static_cast<double>(time - begin) /
           static_cast<double>(std::max<std::int64_t>(1, end - begin));
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const std::vector<Time>* list = times(index);
    if (!list) return;
    const QRect place = option.rect.adjusted(2, 3, -2, -3);
    painter->save();
    painter->fillRect(place, option.palette.color(QPalette::AlternateBase));
    const auto x = [&](Time time) {
      return place.left() + static_cast<int>(shareOf(time) * (place.width() - 1));
    };
    int last = -1;
    for (const Time time : *list) {
      if (x(time) == last) continue;
      last = x(time);
      painter->fillRect(last, place.top(), 1, place.height(), QColor{sideColors[1]});
    }
    if (marked != never())
      painter->fillRect(x(marked), place.top() - 2, 2, place.height() + 4,
                        option.palette.color(QPalette::Highlight));
    painter->restore();
  }
};

DifferenceTree::DifferenceTree() {
  setHeaderLabels({"Value", "Differs", "First", "Largest", "When"});
  header()->setSectionResizeMode(pathColumn, QHeaderView::Interactive);
  header()->setStretchLastSection(true);
  setColumnWidth(pathColumn, 240);
  setColumnWidth(differentColumn, 90);
  setColumnWidth(firstColumn, 150);
  setColumnWidth(largestColumn, 110);
  setUniformRowHeights(true);
  strips_ = new StripDelegate{this};
  strips_->times = [this](const QModelIndex& index) { return timesOf(index); };
  setItemDelegateForColumn(stripColumn, strips_);
  QObject::connect(this, &QTreeWidget::currentItemChanged, this, [this] {
    if (chosen) chosen();
  });
  QObject::connect(this, &QTreeWidget::itemClicked, this,
                   [this](const QTreeWidgetItem* item, int column) {
                     if (column == stripColumn) markAt(*item);
                   });
}

void DifferenceTree::take(LogComparison comparison) {
  comparison_ = std::move(comparison);
  strips_->begin = comparison_.begin;
  strips_->end = comparison_.end;
  strips_->marked = never();
}

void DifferenceTree::filter(const QString& letters, bool onlyDifferent) {
  clear();
  for (std::size_t i = 0; i < comparison_.topics.size(); ++i) {
    const ComparedTopic& topic = comparison_.topics[i];
    if (onlyDifferent && topic.same()) continue;
    auto row = std::make_unique<QTreeWidgetItem>();
    for (std::size_t j = 0; j < topic.values.size(); ++j)
      if (QString::fromStdString(topic.values[j].path).contains(letters, Qt::CaseInsensitive))
        row->addChild(itemOf(topic.values[j], i, j));
    if (row->childCount() == 0 &&
        !QString::fromStdString(topic.name).contains(letters, Qt::CaseInsensitive))
      continue;
    describe(*row, topic);
    row->setData(pathColumn, Qt::UserRole, QVariantList{static_cast<int>(i), -1});
    addTopLevelItem(row.release());
  }
  if (!letters.isEmpty()) expandAll();
  if (chosen) chosen();
}

const DifferentValue* DifferenceTree::chosenValue() const {
  const QTreeWidgetItem* item = currentItem();
  return item ? valueOf(item->data(pathColumn, Qt::UserRole).toList()) : nullptr;
}

Time DifferenceTree::markedTime() const {
  return strips_->marked;
}

void DifferenceTree::mark(Time time) {
  strips_->marked = time;
  viewport()->update();
  if (marked) marked(time);
}

void DifferenceTree::mousePressEvent(QMouseEvent* event) {
  pressed_ = event->pos().x();
  QTreeWidget::mousePressEvent(event);
}

/// The topic and value of a row.
const ComparedTopic* DifferenceTree::topicOf(const QVariantList& place) const {
  return place.size() == 2 ? &comparison_.topics[static_cast<std::size_t>(place[0].toInt())]
                           : nullptr;
}
const DifferentValue* DifferenceTree::valueOf(const QVariantList& place) const {
  const ComparedTopic* topic = topicOf(place);
  const int value = topic ? place[1].toInt() : -1;
  return value < 0 ? nullptr : &topic->values[static_cast<std::size_t>(value)];
}

/// The times of a row's differences, for its strip.
const std::vector<Time>* DifferenceTree::timesOf(const QModelIndex& index) {
  const auto place = index.siblingAtColumn(pathColumn).data(Qt::UserRole).toList();
  if (const DifferentValue* value = valueOf(place)) {
    rowTimes_.clear();
    for (const DifferentValue::Point& point : value->points) rowTimes_.push_back(point.time);
    return &rowTimes_;
  }
  const ComparedTopic* topic = topicOf(place);
  return topic && !topic->times.empty() ? &topic->times : nullptr;
}

/// Marks the difference nearest to where a strip was clicked.
void DifferenceTree::markAt(const QTreeWidgetItem& item) {
  const QModelIndex index = indexAt(visualItemRect(&item).center());
  const auto* times = timesOf(index.siblingAtColumn(stripColumn));
  if (!times || times->empty()) return;
  const int left = header()->sectionViewportPosition(stripColumn);
  const int width = std::max(1, columnWidth(stripColumn));
  const double share = static_cast<double>(pressed_ - left) / width;
  const auto distance = [&](Time time) { return std::abs(strips_->shareOf(time) - share); };
  mark(*std::ranges::min_element(*times, {}, distance));
}

void DifferenceTree::goOn(int direction) {
  if (!currentItem() && topLevelItemCount() > 0) setCurrentItem(topLevelItem(0));
  const auto* times = timesOf(currentIndex());
  if (!times || times->empty()) return;
  const auto next = direction > 0 ? std::ranges::upper_bound(*times, strips_->marked)
                                  : std::ranges::lower_bound(*times, strips_->marked);
  if (direction > 0)
    mark(next == times->end() ? times->back() : *next);
  else
    mark(next == times->begin() ? times->front() : *std::prev(next));
}

}  // namespace gt
