#pragma once
#include <nlohmann/json.hpp>

#include "base/Result.h"
#include "streams/Type.h"

namespace gt {

using Json = nlohmann::ordered_json;

namespace detail {
Json toJson(ConstValue value);
Result<void> fromJson(const Json& json, Value value);
}  // namespace detail

/// A value as JSON: records as objects, enumerations by name, numbers that are not finite as null.
template <Streamable T>
Json toJson(const T& value) {
  return detail::toJson(valueOf(value));
}

/// Reads a value from JSON. Fields that are not mentioned keep their values; unknown fields and
/// values of a wrong kind or out of range are errors that change nothing. The error's field is the
/// path.
template <Streamable T>
Result<void> fromJson(const Json& json, T& value) {
  T copy = value;
  auto result = detail::fromJson(json, valueOf(copy));
  if (result) value = std::move(copy);
  return result;
}

/// Parses text as JSON, within the bounds of base/ParseJson.h; an error's field is the offset in
/// the text.
Result<Json> parseJson(std::string_view text, const std::string& sourceName);

}  // namespace gt
