#pragma once
#include <QTreeWidget>
#include <functional>
#include <vector>

#include "session/ComparedRuns.h"

namespace gt {

/// Colors of the two sides.
constexpr QRgb sideColors[] = {0xff2f7ed8, 0xffe4572e};

inline double inSeconds(Time time) {
  return static_cast<double>(time.ms) / 1000;
}

class StripDelegate;

/// Shows where two runs differ: a row for each representation, and below it one for each of its
/// values, with a strip of the times at which they differ, and a marked time.
class DifferenceTree : public QTreeWidget {
 public:
  DifferenceTree();

  void take(LogComparison comparison);
  const LogComparison& comparison() const { return comparison_; }
  /// Shows only rows whose names contain `letters`, and if `onlyDifferent`, that differ.
  void filter(const QString& letters, bool onlyDifferent);
  /// The value of the current row; null if there is none.
  const DifferentValue* chosenValue() const;

  /// The marked time; never() if none is.
  Time markedTime() const;
  void mark(Time time);
  /// Marks the next difference of the current row, or the previous one if `direction` is negative.
  void goOn(int direction);

  std::function<void()> chosen;  ///< Called when another row becomes the current one.
  std::function<void(Time)> marked;

 protected:
  void mousePressEvent(QMouseEvent* event) override;

 private:
  const ComparedTopic* topicOf(const QVariantList& place) const;
  const DifferentValue* valueOf(const QVariantList& place) const;
  const std::vector<Time>* timesOf(const QModelIndex& index);
  void markAt(const QTreeWidgetItem& item);

  LogComparison comparison_;
  StripDelegate* strips_;
  std::vector<Time> rowTimes_;
  int pressed_ = 0;  ///< Where the mouse was pressed (pixels).
};

}  // namespace gt
