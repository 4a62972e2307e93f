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
  std::string_view qualifiedName;  ///< With namespaces.
  std::uint32_t id;
  std::shared_ptr<void> (*make)();
  void (*copy)(const void* from, void* to);
  void (*swap)(void* a, void* b);
  /// As data; null for types that are not streamed.
  const Type* (*type)();
  /// A value as bytes for a wire: the size, the bytes into room of that size, and back, if it is
  /// one that its type allows (`checked`). Null for types that cannot leave a program.
  std::size_t (*encodedSize)(const void* value);
  void (*encodeTo)(const void* value, std::byte* out);
  Result<void> (*decode)(std::span<const std::byte> bytes, void* value);

  /// Appends a value to a queue; false if there was no room, or the type is not streamed.
  bool write(const void* value, Time time, MessageQueue& queue) const {
    std::byte* place = type() ? queue.reserve(id, name, time, encodedSize(value)) : nullptr;
    if (place) encodeTo(value, place);
    return place != nullptr;
  }
  /// Empty for types that are not streamed.
  Schema schema() const { return type() ? detail::schemaOf(*type()) : Schema{}; }
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
    return Error{.file = "network",
                 .field = "MessageQueue",
                 .what = "the bytes are not a message queue, or too many"};
  }
};

}  // namespace detail

/// The one description of a type; types are the same if their descriptions have the same address.
template <typename T>
const RepresentationType& representation() {
  static constexpr RepresentationType type{
      typeName<T>(),
      qualifiedName<T>(),
      messageId<T>(),
      []() -> std::shared_ptr<void> { return std::make_shared<T>(); },
      [](const void* from, void* to) { *static_cast<T*>(to) = *static_cast<const T*>(from); },
      [](void* a, void* b) { std::swap(*static_cast<T*>(a), *static_cast<T*>(b)); },
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
