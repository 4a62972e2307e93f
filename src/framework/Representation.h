#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "streams/Binary.h"
#include "streams/MessageQueue.h"
#include "streams/Reflection.h"
#include "streams/Schema.h"
#include "streams/Type.h"

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
  /// As data; null for types that are not streamed.
  const Type* (*type)();
  /// A value as bytes for a wire: the size, the bytes into room of that size, and back, if it is
  /// one that its type allows (`checked`). Null for types that do not travel.
  std::size_t (*encodedSize)(const void* value);
  void (*encodeTo)(const void* value, std::byte* out);
  Result<void> (*decode)(std::span<const std::byte> bytes, void* value);
};

namespace detail {

/// How a type travels on a wire: as CDR, a message queue as it is, others not at all.
template <typename T>
struct WireFormat {
  static constexpr std::nullptr_t size = nullptr, write = nullptr, read = nullptr;
};
template <Streamable T>
struct WireFormat<T> {
  static std::size_t size(const void* value) { return encodedSize(*static_cast<const T*>(value)); }
  static void write(const void* value, std::byte* out) {
    encodeTo(*static_cast<const T*>(value), out);
  }
  static Result<void> read(std::span<const std::byte> bytes, void* value) {
    T& to = *static_cast<T*>(value);
    auto done = decode(bytes, to);
    return done ? checked(valueOf(std::as_const(to))) : done;
  }
};
template <>
struct WireFormat<MessageQueue> {
  static std::size_t size(const void* value) {
    return static_cast<const MessageQueue*>(value)->bytes().size();
  }
  static void write(const void* value, std::byte* out) {
    std::ranges::copy(static_cast<const MessageQueue*>(value)->bytes(), out);
  }
  static Result<void> read(std::span<const std::byte> bytes, void* value) {
    if (static_cast<MessageQueue*>(value)->assign(bytes)) return {};
    return Error{"network", 0, "MessageQueue", "this is no message queue, or too large"};
  }
};

}  // namespace detail

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
      },
      []() -> const Type* {
        if constexpr (Streamable<T>)
          return &typeOf<T>();
        else
          return nullptr;
      },
      detail::WireFormat<T>::size,
      detail::WireFormat<T>::write,
      detail::WireFormat<T>::read};
  return type;
}

}  // namespace gt
