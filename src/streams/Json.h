#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/Result.h"
#include "streams/Type.h"

/// Include nlohmann/json.hpp only to work on JSON values directly, because it takes long to
/// compile; otherwise use jsonText() and readJson().
namespace gt {

using Json = nlohmann::ordered_json;

namespace detail {
Json toJson(ConstValue value);
Result<void> fromJson(const Json& json, Value value);
std::string jsonText(ConstValue value, int indent);
Result<void> readJson(std::string_view text, const std::string& sourceName, Value value);
}  // namespace detail

/// Converts a value to Json: records become objects, enumerations their names, and numbers that are
/// not finite null.
template <Streamable T>
auto toJson(const T& value) {
  return detail::toJson(valueOf(value));
}

/// Reads a value from JSON. Fields that are not mentioned keep their values. Unknown fields and
/// values that have a wrong kind or are out of range are errors that change nothing. The error's
/// field is the path.
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

/// Writes a value as JSON: on one line, or with each field on a line of its own, indented by
/// `indent` blanks per level.
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
