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

/// The one description of a type; types are the same if their descriptions have the same address.
/// All units use it, and it takes long to compile: so it is only declared here. Those of the
/// representations are compiled in representations/RepresentationTypes.cpp, those of other messages
/// in logs/MessageTypes.cpp; who has further types includes
/// framework/RepresentationDefinition.h.
template <typename T>
const RepresentationType& representation();

}  // namespace gt
