#include "streams/Json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/Number.h"
#include "base/ParseJson.h"

namespace gt {
namespace {

Json scalarJson(ConstValue value) {
  const Type& type = value.type();
  if (type.kind == Kind::boolean) return ordinal(value) != 0;
  if (type.kind != Kind::number) return scalarText(value);
  switch (type.number) {
    case Number::float32: {
      if (!std::isfinite(*static_cast<const float*>(value.data()))) return {};
      // By its shortest text, so that 0.1f is 0.1 and not 0.10000000149; -0 keeps its sign.
      return *numberFrom<double>(scalarText(value));
    }
    case Number::float64:
      return std::isfinite(*static_cast<const double*>(value.data()))
                 ? Json(*static_cast<const double*>(value.data()))
                 : Json();
    case Number::uint64:
      return static_cast<std::uint64_t>(ordinal(value));
    default:
      return ordinal(value);
  }
}

Error wrong(const std::string& path, std::string what) {
  return {.field = path, .what = std::move(what)};
}

std::string joined(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : path + "." + std::string(name);
}

/// Reads JSON into values, with the path to where it is.
class JsonReader {
 public:
  std::optional<Error> read(const Json& json, Value value, Range range, const std::string& path) {
    switch (value.type->kind) {
      case Kind::record:
        return readRecord(json, value, path);
      case Kind::array:
      case Kind::list:
        return readSequence(json, value, range, path);
      default:
        return readScalar(json, value, range, path);
    }
  }

 private:
  std::optional<Error> readRecord(const Json& json, Value value, const std::string& path) {
    if (!json.is_object()) return wrong(path, "expected an object");
    for (const auto& [key, content] : json.items()) {
      const std::string name = joined(path, key);
      const Part* part = nullptr;
      for (const Part& p : value.type->parts)
        if (p.name == key) part = &p;
      if (part == nullptr) return wrong(name, "unknown name");
      if (auto error = read(content, value.part(*part), part->range, name)) return error;
    }
    return std::nullopt;
  }

  std::optional<Error> readSequence(const Json& json, Value value, Range range,
                                    const std::string& path) {
    if (!json.is_array()) return wrong(path, "expected an array");
    if (value.type->kind == Kind::list)
      value.type->resize(value.data, json.size());
    else if (json.size() != value.size())
      return wrong(path, "expected " + std::to_string(value.size()) + " elements");
    for (std::size_t i = 0; i < json.size(); ++i)
      if (auto error = read(json[i], value.element(i), range, joined(path, std::to_string(i))))
        return error;
    return std::nullopt;
  }

  std::optional<Error> readScalar(const Json& json, Value value, Range range,
                                  const std::string& path) {
    const Kind kind = value.type->kind;
    const bool isFloat = kind == Kind::number && (value.type->number == Number::float32 ||
                                                  value.type->number == Number::float64);
    const bool fits = kind == Kind::boolean  ? json.is_boolean()
                      : kind == Kind::number ? json.is_number() || (isFloat && json.is_null())
                                             : json.is_string();
    if (!fits) return wrong(path, "has a value of a wrong kind");
    const std::string text = json.is_string() ? json.get<std::string>()
                             : json.is_null() ? std::string("nan")
                                              : json.dump();
    if (const auto done = setScalar(value, text, range); !done)
      return wrong(path, done.error().what);
    return std::nullopt;
  }
};

}  // namespace

Json detail::toJson(ConstValue value) {
  const Type& type = value.type();
  if (type.kind == Kind::record) {
    Json object = Json::object();
    for (const Part& p : type.parts) object[std::string(p.name)] = toJson(value.part(p));
    return object;
  }
  if (type.kind == Kind::array || type.kind == Kind::list) {
    Json array = Json::array();
    for (std::size_t i = 0; i < value.size(); ++i) array.push_back(toJson(value.element(i)));
    return array;
  }
  return scalarJson(value);
}

Result<void> detail::fromJson(const Json& json, Value value) {
  if (auto error = JsonReader{}.read(json, value, {}, "")) return *error;
  return {};
}

std::string detail::jsonText(ConstValue value, int indent) {
  return toJson(value).dump(indent);
}

Result<void> detail::readJson(std::string_view text, const std::string& sourceName, Value value) {
  const auto json = parseJson(text, sourceName);
  if (!json) return json.error();
  auto done = fromJson(*json, value);
  if (done) return done;
  Error error = done.error();
  error.file = sourceName;
  return error;
}

Result<Json> parseJson(std::string_view text, const std::string& sourceName) {
  return parseJsonAs<Json>(text, sourceName);
}

}  // namespace gt
