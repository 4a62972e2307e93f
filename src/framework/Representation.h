#pragma once
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "streams/Binary.h"
#include "streams/MessageQueue.h"
#include "streams/Reflection.h"
#include "streams/Schema.h"

namespace gt {

/// What the framework knows of a representation's type, so that it can carry values without knowing
/// them.
struct RepresentationType {
  std::string_view name;
  std::uint32_t id;
  std::shared_ptr<void> (*make)();
  void (*copy)(const void* from, void* to);
  void (*swap)(void* a, void* b);
  bool (*write)(const void* value, Time time, MessageQueue& queue);
  Result<void> (*read)(const Message& message, void* value);
  Schema (*schema)();
};

/// The one description of a type; types are the same if their descriptions have the same address.
template <typename T>
const RepresentationType& representation() {
  static constexpr RepresentationType type{
      typeName<T>(),
      messageId<T>(),
      []() -> std::shared_ptr<void> { return std::make_shared<T>(); },
      [](const void* from, void* to) { *static_cast<T*>(to) = *static_cast<const T*>(from); },
      [](void* a, void* b) { std::swap(*static_cast<T*>(a), *static_cast<T*>(b)); },
      [](const void* value, Time time, MessageQueue& queue) {
        if constexpr (Streamable<T>)
          return queue.write(time, *static_cast<const T*>(value));
        else
          return false;
      },
      [](const Message& message, void* value) -> Result<void> {
        if constexpr (Streamable<T>)
          return message.read(*static_cast<T*>(value));
        else
          return Error{"", 0, std::string{typeName<T>()}, "is not part of messages"};
      },
      []() -> Schema {
        if constexpr (Streamable<T>)
          return schemaOf<T>();
        else
          return {};
      }};
  return type;
}

}  // namespace gt
