#pragma once
#include <span>

#include "streams/Json.h"
#include "streams/MessageDefinition.h"

/// Reading messages by the schema that was recorded with them, whatever program wrote them. Both
/// functions refuse messages of more than four million scalars and elements.
namespace gt {

/// Reads a message into a value whose type may have changed since: fields are found by name, what
/// was not recorded keeps its value, what is not there any more is passed over. Numbers are
/// converted (rounded and kept in range where need be), enumerations go by name where the schema
/// tells names. A value that its type does not allow is an error (`checked`). After an error the
/// value may be changed in part.
Result<void> readRecorded(const MessageDefinition& definition, std::span<const std::byte> bytes,
                          Value value);
template <Streamable T>
Result<void> readRecorded(const MessageDefinition& definition, std::span<const std::byte> bytes,
                          T& value) {
  return readRecorded(definition, bytes, valueOf(value));
}

/// A message as JSON: names as in the schema, enumerations by name where it has them, lists of
/// bytes as base64, numbers that are not finite as null.
Result<Json> recordedJson(const MessageDefinition& definition, std::span<const std::byte> bytes);

}  // namespace gt
