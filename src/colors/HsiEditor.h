#pragma once
#include <deque>

#include "colors/HsiColors.h"

namespace gt {

/// Makes color classes as sectors of the HSI space, by sliders or by clicking on pixels (report
/// J.6.2). The last changes can be undone.
class HsiEditor {
 public:
  explicit HsiEditor(const HsiColors& colors = {}) : colors_(colors) {}

  const HsiColors& colors() const { return colors_; }

  /// The sliders: any values, cut to those that there are.
  void setRange(ColorClass colorClass, HsiRange range);
  /// The left button: the class grows until the pixel's color lies in it.
  void include(ColorClass colorClass, const Pixel& pixel);
  /// The right button: the class shrinks until the pixel's color lies outside.
  void exclude(ColorClass colorClass, const Pixel& pixel);

  /// Takes the last change back; false if there is none. A hundred are known.
  bool undo();

 private:
  void change(ColorClass colorClass, const HsiRange& range);

  HsiColors colors_;
  std::deque<HsiColors> before_;
};

}  // namespace gt
