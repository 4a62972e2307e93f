#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/File.h"
#include "base/Findings.h"
#include "streams/Type.h"

/// The config format (report B.4, D.2): lines `name value ...` or `name = value ...`. Nested fields
/// have a dotted path, or stand below a line `[path]`. Words and comments are as in base/Lines.h.
/// Fields that are not mentioned keep their values.
namespace gt {

/// A field that can be read and set by its path.
struct PathInfo {
  std::string path;  ///< As in "info.width", "flags.0.distance", "angles.headTilt".
  PartInfo info;     ///< Of the last field on the path.
  Value value;       ///< One or more scalars.
};

/// Selects a part of a config file.
struct ConfigOptions {
  std::string section{};  ///< If given, only this section is read, and it must exist.
  bool common = false;    ///< Only the lines before the first section are read.
};

/// A line [NAME] of a config file.
struct ConfigSection {
  std::string name;
  int line;
};

namespace detail {
Findings parseConfig(std::string_view text, const std::string& source, const ConfigOptions& options,
                     Value value);
std::vector<ConfigSection> configSections(std::string_view text);
void writeConfig(ConstValue value, std::string& out);
Result<void> setByPath(Value root, std::string_view path, std::string_view text);
Result<std::string> getByPath(ConstValue root, std::string_view path);
std::vector<PathInfo> paths(ConstValue root);
}  // namespace detail

/// Reads text in the config format into a value. Returns all errors: unknown or repeated names,
/// wrong or missing values, values out of range. After an error the value is unchanged.
template <Streamable T>
Findings collectConfig(std::string_view text, const std::string& sourceName, T& value,
                       const ConfigOptions& options = {}) {
  T copy = value;
  Findings findings = detail::parseConfig(text, sourceName, options, valueOf(copy));
  if (findings.empty()) value = std::move(copy);
  return findings;
}

/// Like collectConfig, but returns only the first error.
template <Streamable T>
Result<void> parseConfig(std::string_view text, const std::string& sourceName, T& value,
                         const ConfigOptions& options = {}) {
  return collectConfig(text, sourceName, value, options).firstError();
}

/// Reads a config file into a value; see parseConfig.
template <Streamable T>
Result<void> readConfig(const std::string& path, T& value, const ConfigOptions& options = {}) {
  const auto text = readFile(path);
  return text ? parseConfig(*text, path, value, options) : text.error();
}

/// Writes a value in the config format, with units and sentences as comments. Reading it yields the
/// same value, bit for bit except for the payload of NaNs.
template <Streamable T>
std::string writeConfig(const T& value) {
  std::string out;
  detail::writeConfig(valueOf(value), out);
  return out;
}

/// Sets the field at a path from text in the format of a config file. Unknown paths, wrong values
/// and values out of range are errors that change nothing.
template <Streamable T>
Result<void> setByPath(T& value, std::string_view path, std::string_view text) {
  T copy = value;
  auto result = detail::setByPath(valueOf(copy), path, text);
  if (result) value = std::move(copy);
  return result;
}

/// Returns the field at a path as text in the format of a config file.
template <Streamable T>
Result<std::string> getByPath(const T& value, std::string_view path) {
  return detail::getByPath(valueOf(value), path);
}

/// Returns all fields that can be read and set by path, with units, sentences and ranges. The
/// entries refer to the value; those inside a list of records are valid only until its length
/// changes.
template <Streamable T>
std::vector<PathInfo> paths(T& value) {
  return detail::paths(valueOf(value));
}

}  // namespace gt
