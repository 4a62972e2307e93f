#pragma once
#include <span>

#include "streams/Json.h"
#include "streams/MessageDefinition.h"

/// Reads messages by the schema that was recorded with them, regardless of the program that wrote
/// them. Both functions refuse messages of more than four million scalars and elements.
namespace gt {

/// Reads a message into a value whose type may have changed since the recording. Fields are matched
/// by name; fields that were not recorded keep their values, and recorded fields that no longer
/// exist are skipped. Numbers are converted (rounded and clamped if necessary). Enumerations are
/// matched by name if the schema has names. A value that its type does not allow is an error
/// (`checked`). After an error a part of the value may be changed.
Result<void> readRecorded(const MessageDefinition& definition, std::span<const std::byte> bytes,
                          Value value);
template <Streamable T>
Result<void> readRecorded(const MessageDefinition& definition, std::span<const std::byte> bytes,
                          T& value) {
  return readRecorded(definition, bytes, valueOf(value));
}

/// Converts a message to JSON: field names as in the schema, enumerations by name if the schema has
/// names, lists of bytes as base64, numbers that are not finite as null.
Result<Json> recordedJson(const MessageDefinition& definition, std::span<const std::byte> bytes);

}  // namespace gt
