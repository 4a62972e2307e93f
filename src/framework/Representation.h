#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "streams/MessageQueue.h"
#include "streams/Schema.h"
#include "streams/Type.h"

namespace gt {

/// Type information about a representation, so that the framework can handle values without knowing
/// their C++ types.
struct RepresentationType {
  std::string_view name;
  std::string_view qualifiedName;  ///< With namespaces.
  std::uint32_t id;
  std::shared_ptr<void> (*make)();
  void (*copy)(const void* from, void* to);
  void (*swap)(void* a, void* b);
  /// The type as data; null for types that are not streamed.
  const Type* (*type)();
  /// Encodes a value as bytes for transmission (its size, and writing to memory of that size), and
  /// decodes it if its type allows the value (`checked`). Null for types that cannot leave a
  /// program.
  std::size_t (*encodedSize)(const void* value);
  void (*encodeTo)(const void* value, std::byte* out);
  Result<void> (*decode)(std::span<const std::byte> bytes, void* value);

  /// Appends a value to a queue. Returns false if the queue is full, or the type is not streamed.
  bool write(const void* value, Time time, MessageQueue& queue) const {
    std::byte* place = type() ? queue.reserve(id, name, time, encodedSize(value)) : nullptr;
    if (place) encodeTo(value, place);
    return place != nullptr;
  }
  /// Schema of the type; empty for types that are not streamed.
  Schema schema() const { return type() ? detail::schemaOf(*type()) : Schema{}; }
};

/// The unique description of a type; types are the same if their descriptions have the same
/// address. It is only declared here, because all units use it and its definition takes long to
/// compile. The descriptions of the representations are compiled in
/// representations/RepresentationTypes.cpp, those of other messages in logs/MessageTypes.cpp. Units
/// with further types include framework/RepresentationDefinition.h.
template <typename T>
const RepresentationType& representation();

}  // namespace gt
