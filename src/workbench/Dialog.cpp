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

std::vector<DialogType> Dialog::types() {
  std::vector<DialogType> types = allTypes();
  std::ranges::sort(types, {}, [](const DialogType& type) {
    return std::tuple{std::string_view{type.group}, std::string_view{type.title}};
  });
  return types;
}

}  // namespace gt
