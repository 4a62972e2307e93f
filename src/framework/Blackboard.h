#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/Contract.h"
#include "framework/Representation.h"

namespace gt {

/// The representations of one process, one instance of each type. They are looked up when modules
/// are bound, not during a cycle.
class Blackboard {
 public:
  /// The place of one representation. Its address does not change; its value may be replaced.
  struct Slot {
    const RepresentationType* type = nullptr;
    std::shared_ptr<void> value;
    bool shared = false;
  };

  template <typename T>
  T& get() {
    return *static_cast<T*>(get(representation<T>()));
  }
  void* get(const RepresentationType& type) { return slot(type).value.get(); }
  const Slot& slot(const RepresentationType& type) { return place(type); }
  /// Returns a value for writing that only this blackboard uses: a shared value is copied before.
  void* own(const RepresentationType& type) {
    Slot& slot = place(type);
    if (slot.shared) {
      std::shared_ptr<void> value = type.make();
      type.copy(slot.value.get(), value.get());
      slot = {&type, std::move(value), false};
    }
    return slot.value.get();
  }
  /// Registers a value that several blackboards share, such as a color table.
  void share(const RepresentationType& type, std::shared_ptr<void> value) {
    slots_[type.name] = {&type, std::move(value), true};
  }

  /// Copies those values from another blackboard that both have. Shared values stay shared.
  void copyFrom(const Blackboard& other) {
    for (const auto& [name, slot] : other.slots_)
      if (const auto here = slots_.find(name);
          here != slots_.end() && here->second.value != slot.value)
        slot.type->copy(slot.value.get(), own(*slot.type));
  }
  /// Returns the type of a slot by name or message id; null if there is none.
  const RepresentationType* find(std::string_view name) const {
    const auto slot = slots_.find(name);
    return slot == slots_.end() ? nullptr : slot->second.type;
  }
  const RepresentationType* find(std::uint32_t id) const {
    for (const auto& [name, slot] : slots_)
      if (slot.type->id == id) return slot.type;
    return nullptr;
  }
  std::vector<const RepresentationType*> types() const {
    std::vector<const RepresentationType*> types;
    for (const auto& [name, slot] : slots_) types.push_back(slot.type);
    return types;
  }

 private:
  Slot& place(const RepresentationType& type) {
    Slot& slot = slots_[type.name];
    if (!slot.value) slot = {&type, type.make(), false};
    if (slot.type != &type)
      violate(std::string{type.qualifiedName} + " and " + std::string{slot.type->qualifiedName} +
              " cannot be distinguished: a representation's name is its own in all namespaces.");
    return slot;
  }

  std::map<std::string_view, Slot> slots_;
};

}  // namespace gt
