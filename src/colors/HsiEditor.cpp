#include "colors/HsiEditor.h"

#include <algorithm>

namespace gt {

void HsiEditor::setRange(ColorClass colorClass, HsiRange range) {
  const auto cut = [](ColorRange& values, int highest) {
    for (int& value : values) value = std::clamp(value, 0, highest);
  };
  cut(range.hue, 360);
  cut(range.saturation, 100);
  cut(range.intensity, 100);
  change(colorClass, range);
}

void HsiEditor::include(ColorClass colorClass, const Pixel& pixel) {
  HsiRange range = colors_.ranges[colorClass];
  range.include(hsiOf(pixel));
  change(colorClass, range);
}

void HsiEditor::exclude(ColorClass colorClass, const Pixel& pixel) {
  HsiRange range = colors_.ranges[colorClass];
  range.exclude(hsiOf(pixel));
  change(colorClass, range);
}

void HsiEditor::change(ColorClass colorClass, const HsiRange& range) {
  if (colorClass == ColorClass::noColor || range == colors_.ranges[colorClass]) return;
  constexpr std::size_t mostSteps = 100;
  before_.push_back(colors_);
  if (before_.size() > mostSteps) before_.pop_front();
  colors_.ranges[colorClass] = range;
}

bool HsiEditor::undo() {
  if (before_.empty()) return false;
  colors_ = before_.back();
  before_.pop_back();
  return true;
}

}  // namespace gt
