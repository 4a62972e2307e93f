#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "labels/LabelErrors.h"
#include "workbench/CustomPlot.h"

namespace gt {

/// How far vision is off the labels of a log's images: a point for each thing that was found, a
/// cross for each that was not or that is not there; over time, or over distance.
class LabelErrorPlot : public QCustomPlot {
 public:
  LabelErrorPlot();

  void setErrors(std::vector<LabelError> errors);
  void setOverDistance(bool overDistance);
  /// How many were found and how far they are off, for each kind; empty if nothing is labeled.
  QString summary() const;
  /// Writes all errors as a table (CSV).
  Result<void> exportTo(const std::string& file) const;

  /// A click on an error.
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
