#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "framework/Representation.h"
#include "streams/Binary.h"
#include "streams/Reflection.h"

/// Defines representation(), for units that describe types of their own.
namespace gt {

namespace detail {

/// The format of a type in transmissions: CDR; a message queue is sent unchanged; other types are
/// not sent.
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
