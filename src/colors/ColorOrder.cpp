#include "colors/ColorOrder.h"

#include <algorithm>

namespace gt {
namespace {

bool seemsOfOtherOrder(const ColorTable64& table) {
  const auto isOfFields = [](ColorClass c) {
    return c == ColorClass::green || c == ColorClass::white || c == ColorClass::gray;
  };
  const auto isNone = [](ColorClass c) { return c == ColorClass::noColor; };
  return std::ranges::none_of(table.classes, isOfFields) &&
         !std::ranges::all_of(table.classes, isNone);
}

}  // namespace

std::string doubtOfOrder(const ColorTable64& table, const std::string& file, bool nao2009,
                         const std::string& remedy) {
  if (!seemsOfOtherOrder(table)) return "";
  return file + ": has no green, white and gray, so its classes are probably those of " +
         (nao2009 ? "the report: " : "a robot of 2009: ") + remedy;
}

}  // namespace gt
