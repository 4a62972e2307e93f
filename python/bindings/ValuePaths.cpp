#include <algorithm>
#include <charconv>
#include <optional>

#include "ValueParts.h"
#include "Values.h"
#include "base/Suggestion.h"
#include "streams/Schema.h"

namespace gt::python {
namespace {

/// An element of a sequence by its name or number; none if it has none.
std::optional<std::size_t> elementIndex(const Type& sequence, std::size_t size,
                                        std::string_view name) {
  const auto named = std::ranges::find(sequence.indexNames, name);
  if (named != sequence.indexNames.end())
    return static_cast<std::size_t>(named - sequence.indexNames.begin());
  std::size_t index = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (failure != std::errc{} || end != name.data() + name.size() || index >= size)
    return std::nullopt;
  return index;
}

}  // namespace

const Part* partOf(const Type& record, std::string_view name) {
  auto found = std::ranges::find(record.parts, name, &Part::name);
  if (found == record.parts.end())
    found = std::ranges::find_if(record.parts,
                                 [&](const Part& part) { return snakeCase(part.name) == name; });
  return found == record.parts.end() ? nullptr : &*found;
}

std::string noSuchField(const Type& record, std::string_view name) {
  return std::string{record.name} + " has no field " + std::string{name} +
         suggestion(name, namesIn(record.parts));
}

ConstValue at(ConstValue root, std::string_view path, const std::string& whole,
              std::string* spelled) {
  while (!path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string_view name = path.substr(0, dot);
    path.remove_prefix(std::min(dot + 1, path.size()));
    const Type& type = root.type();
    if (type.kind == Kind::record) {
      const Part* part = partOf(type, name);
      if (!part) fail({nullptr, whole}, noSuchField(type, name));
      root = root.part(*part);
      if (spelled) spelled->append(".").append(part->name);
      continue;
    } else if (type.kind == Kind::array || type.kind == Kind::list) {
      const auto index = elementIndex(type, root.size(), name);
      if (!index) fail({nullptr, whole}, "there is no element " + std::string{name});
      root = root.element(*index);
    } else {
      fail({nullptr, whole}, "a single value has no field " + std::string{name});
    }
    if (spelled) spelled->append(".").append(name);
  }
  return root;
}

std::pair<std::string, std::string> splitPath(const std::string& path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  return {path.substr(0, dot), path.substr(std::min(dot + 1, path.size()))};
}

}  // namespace gt::python
