#pragma once
#include <QList>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "workbench/CurveFilter.h"
#include "workbench/CustomPlot.h"
#include "workbench/PlottedValues.h"

namespace gt {

/// A plot of values over time, or over one of them.
class CurvePlot : public QCustomPlot {
 public:
  /// Axes for the values, the first at the left, the others at the right.
  static constexpr std::array axisNames = {"Left", "Right", "Second right", "Third right"};
  static constexpr int axisCount = static_cast<int>(axisNames.size());
  static constexpr std::array filters = {
      std::pair{CurveFilterKind::none, "As it is"},
      std::pair{CurveFilterKind::derivative, "Derivative (per s)"},
      std::pair{CurveFilterKind::mean200ms, "Mean of 0.2 s"},
      std::pair{CurveFilterKind::mean1s, "Mean of 1 s"}};

  struct Curve {
    QCPGraph* graph = nullptr;
    QCPCurve* overX = nullptr;  ///< The curve over another value.
    Time last = never();
    QCPGraph* before = nullptr;                   ///< The run before a reset, to compare with.
    std::deque<std::pair<double, double>> raw{};  ///< Times (s) and values without the filter.
    CurveFilter filter{};
  };

  CurvePlot();

  const std::map<std::string, Curve>& curves() const { return curves_; }
  /// Adds a curve for a value; false if it is there already.
  bool add(const std::string& name, int axis, CurveFilterKind filter);
  void remove(const std::string& name);
  void clear();
  int axisOf(const Curve& curve) const;
  void setAxis(const std::string& name, int axis);
  void setFilter(const std::string& name, CurveFilterKind kind);
  /// The name of the value on the x axis, which is one of those shown; empty: time.
  const std::string& x() const { return x_; }
  void setX(const std::string& name);

  /// Adds new points; those of values without a curve are ignored.
  void take(const PlottedValues& news);
  /// To be called when the session begins anew: keeps the present curves, faint, until the next
  /// call.
  void keepRuns();
  /// Shows the last `seconds`.
  void follow(double seconds);
  /// The values at a time (s) as text, a line for each.
  QString textAt(double time) const;
  /// The value at a time (s): that of the newest point that is not later; empty if there is none.
  static std::optional<double> valueIn(const QCPGraphDataContainer& points, double time);

  /// Writes all points to a file, a line for each time.
  Result<void> exportTo(const std::string& file) const;

 private:
  void keepRun(Curve& curve);
  static void filterAnew(Curve& curve, CurveFilterKind kind);
  static void nameCurve(const std::string& name, Curve& curve);
  void showParts();
  void drawOverX(double seconds);
  void fit(QCPAxis* axis);

  QList<QCPAxis*> axes_;
  std::map<std::string, Curve> curves_;
  std::string x_;
  std::size_t colors_ = 0;
  double now_ = 0;  ///< s
};

}  // namespace gt
