#include "workbench/Dialog.h"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace gt {
namespace {

std::vector<DialogType>& allTypes() {
  static std::vector<DialogType> types;
  return types;
}

}  // namespace

void Dialog::add(const DialogType& type) {
  allTypes().push_back(type);
}

const DialogType* Dialog::typeOf(const QString& key) {
  const auto& types = allTypes();
  const auto found = std::ranges::find(types, key.section('#', 0, 0), &DialogType::id);
  return found == types.end() ? nullptr : &*found;
}

std::vector<DialogType> Dialog::types() {
  std::vector<DialogType> types = allTypes();
  std::ranges::sort(types, {}, [](const DialogType& type) {
    return std::tuple{std::string_view{type.group}, std::string_view{type.title}};
  });
  return types;
}

}  // namespace gt
