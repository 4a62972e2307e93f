#include "colors/ColorOrder.h"

#include <algorithm>

namespace gt {

bool seemsOfOtherOrder(const ColorTable64& table) {
  const auto isOfFields = [](ColorClass c) {
    return c == ColorClass::green || c == ColorClass::white || c == ColorClass::gray;
  };
  const auto isNone = [](ColorClass c) { return c == ColorClass::noColor; };
  return std::ranges::none_of(table.classes, isOfFields) &&
         !std::ranges::all_of(table.classes, isNone);
}

}  // namespace gt
