#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/Result.h"
#include "streams/Type.h"

/// Who works on values of JSON themselves includes nlohmann/json.hpp, which takes long to compile;
/// for others there are jsonText() and readJson().
namespace gt {

using Json = nlohmann::ordered_json;

namespace detail {
Json toJson(ConstValue value);
Result<void> fromJson(const Json& json, Value value);
std::string jsonText(ConstValue value, int indent);
Result<void> readJson(std::string_view text, const std::string& sourceName, Value value);
}  // namespace detail

/// A value as Json: records as objects, enumerations by name, numbers that are not finite as null.
template <Streamable T>
auto toJson(const T& value) {
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

/// A value as a text of JSON: on one line, or with each field on a line of its own, `indent` blanks
/// further than what it is a part of.
template <Streamable T>
std::string jsonText(const T& value, int indent = -1) {
  return detail::jsonText(valueOf(value), indent);
}

/// Parses text as JSON and reads a value from it, as fromJson() does. An error names the source and
/// the path.
template <Streamable T>
Result<void> readJson(std::string_view text, const std::string& sourceName, T& value) {
  T copy = value;
  auto result = detail::readJson(text, sourceName, valueOf(copy));
  if (result) value = std::move(copy);
  return result;
}

}  // namespace gt
