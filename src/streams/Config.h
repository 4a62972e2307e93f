#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/File.h"
#include "base/Findings.h"
#include "streams/Type.h"

/// The config format (report B.4, D.2): lines `name value ...` or `name = value ...`, fields of
/// fields by a dotted path or below a line `[path]`; words and comments as in base/Lines.h.
/// Fields that are not mentioned keep their values.
namespace gt {

/// A field that can be read and set by its path.
struct PathInfo {
  std::string path;  ///< As in "info.width", "flags.0.distance", "angles.headTilt".
  PartInfo info;     ///< Of the last field on the path.
  Value value;       ///< Flat: one or more scalars.
};

/// What of a config file is read.
struct ConfigOptions {
  std::string section{};  ///< If given, only this section is read, and there must be one.
  bool common = false;    ///< Only what stands before the first section is read.
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
std::vector<PathInfo> paths(Value root);
}  // namespace detail

/// Reads text in the config format into a value; returns all errors: unknown or repeated names,
/// wrong or missing values, values out of range. If there is one, the value stays as it was.
template <Streamable T>
Findings collectConfig(std::string_view text, const std::string& sourceName, T& value,
                       const ConfigOptions& options = {}) {
  T copy = value;
  Findings findings = detail::parseConfig(text, sourceName, options, valueOf(copy));
  if (findings.empty()) value = std::move(copy);
  return findings;
}

/// The same; returns the first error.
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

/// A value in the config format, with units and sentences as comments; reading it gives the same
/// value, bit for bit except for the payload of NaNs.
template <Streamable T>
std::string writeConfig(const T& value) {
  std::string out;
  detail::writeConfig(valueOf(value), out);
  return out;
}

/// Sets the field at a path from text as in a config file. Unknown paths, wrong values and values
/// out of range are errors that change nothing.
template <Streamable T>
Result<void> setByPath(T& value, std::string_view path, std::string_view text) {
  T copy = value;
  auto result = detail::setByPath(valueOf(copy), path, text);
  if (result) value = std::move(copy);
  return result;
}

/// The field at a path as text, as in a config file.
template <Streamable T>
Result<std::string> getByPath(const T& value, std::string_view path) {
  return detail::getByPath(valueOf(value), path);
}

/// All fields that can be read and set by path, with units, sentences and ranges. The entries
/// refer to the value; those below a list of records only until its length changes.
template <Streamable T>
std::vector<PathInfo> paths(T& value) {
  return detail::paths(valueOf(value));
}

}  // namespace gt
