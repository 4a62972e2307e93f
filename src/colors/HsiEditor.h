#pragma once
#include <deque>

#include "colors/HsiColors.h"

namespace gt {

/// Defines color classes as sectors of the HSI space, by sliders or by clicking on pixels (report
/// J.6.2). The last changes can be undone.
class HsiEditor {
 public:
  explicit HsiEditor(const HsiColors& colors = {}) : colors_(colors) {}

  const HsiColors& colors() const { return colors_; }

  /// Sets a range by the sliders. Values are clamped to their limits.
  void setRange(ColorClass colorClass, HsiRange range);
  /// Enlarges the class to include the pixel's color (left button).
  void include(ColorClass colorClass, const Pixel& pixel);
  /// Reduces the class to exclude the pixel's color (right button).
  void exclude(ColorClass colorClass, const Pixel& pixel);

  /// Undoes the last change. Returns false if there is none. At most a hundred changes are stored.
  bool undo();

 private:
  void change(ColorClass colorClass, const HsiRange& range);

  HsiColors colors_;
  std::deque<HsiColors> before_;
};

}  // namespace gt
