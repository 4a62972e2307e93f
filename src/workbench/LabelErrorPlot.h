#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "labels/LabelErrors.h"
#include "workbench/CustomPlot.h"

namespace gt {

/// Plots the errors of percepts against the labels of a log's images, over time or over distance: a
/// point for each labeled thing that was found, a cross for each miss and each false positive.
class LabelErrorPlot : public QCustomPlot {
 public:
  LabelErrorPlot();

  void setErrors(std::vector<LabelError> errors);
  void setOverDistance(bool overDistance);
  /// Summarizes for each kind how many were found, and their errors; empty if nothing is labeled.
  QString summary() const;
  /// Writes all errors as a table (CSV).
  Result<void> exportTo(const std::string& file) const;

  /// Called when a person clicks on an error.
  std::function<void(const LabelError&)> clicked;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  double placeOf(const LabelError& error) const;
  bool isShown(const LabelError& error) const;
  const LabelError* errorAt(const QPointF& at) const;
  void drawErrors();

  std::vector<LabelError> errors_;
  bool overDistance_ = false;
};

}  // namespace gt
