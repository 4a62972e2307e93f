#pragma once
#include <map>
#include <memory>
#include <string>

#include "framework/Representation.h"

namespace gt {

/// The representations of one process, one instance of each type. Looked up when modules are bound,
/// never in a cycle.
class Blackboard {
 public:
  template <typename T>
  T& get() {
    return *static_cast<T*>(get(representation<T>()));
  }
  void* get(const RepresentationType& type) {
    auto& slot = slots_[type.name];
    if (!slot.value) slot = {&type, type.make(), false};
    return slot.value.get();
  }
  /// Lays in a value that several blackboards share, such as a colour table; only before modules
  /// are bound.
  template <typename T>
  void share(std::shared_ptr<T> value) {
    slots_[representation<T>().name] = {&representation<T>(), std::move(value), true};
  }

  /// Takes over the values that another blackboard holds too; both keep those that are shared.
  void copyFrom(const Blackboard& other) {
    for (auto& [name, slot] : slots_)
      if (const auto found = other.slots_.find(name);
          found != other.slots_.end() && found->second.value != slot.value)
        slot.type->copy(found->second.value.get(), slot.value.get());
  }
  /// The type of a slot, by name; null if there is none.
  const RepresentationType* find(std::string_view name) const {
    const auto slot = slots_.find(name);
    return slot == slots_.end() ? nullptr : slot->second.type;
  }
  /// The type of a slot that is not shared, by its message id; null if there is none.
  const RepresentationType* findOwn(std::uint32_t id) const {
    for (const auto& [name, slot] : slots_)
      if (slot.type->id == id && !slot.shared) return slot.type;
    return nullptr;
  }

 private:
  struct Slot {
    const RepresentationType* type = nullptr;
    std::shared_ptr<void> value;
    bool shared = false;
  };
  std::map<std::string_view, Slot> slots_;
};

}  // namespace gt
