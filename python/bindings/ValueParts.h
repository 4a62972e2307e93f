#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "Failure.h"
#include "Types.h"
#include "streams/NumberType.h"
#include "streams/Type.h"

/// What reading and setting values from Python share.
namespace gt::python {

/// Where a value stands, as the text of a path only once it is needed.
struct Place {
  const Place* record;  ///< That it is a part of; null: none.
  std::string_view name;

  std::string text() const {
    const std::string before = record ? record->text() : "";
    return before.empty() ? std::string{name} : before + "." + std::string{name};
  }
};

[[noreturn]] inline void fail(const Place& place, std::string what) {
  throw Failure{Error{.field = place.text(), .what = std::move(what)}};
}

/// A field by its name, or by that which it has in logs (`last_seen` for lastSeen). Null: none.
const Part* partOf(const Type& record, std::string_view name);
/// What is wrong with the name of a field.
std::string noSuchField(const Type& record, std::string_view name);

/// The form of a list whose elements are scalars or dense; empty if they are not.
std::optional<Dense> denseListForm(ConstValue value);

/// Calls visit(scalar, place) for each scalar and its place in an array that begins at `place`,
/// which is moved behind them.
template <typename Visit>
void forEachScalar(Value value, std::byte*& place, Visit&& visit) {
  const Type& type = *value.type;
  for (const Part& part : type.parts) forEachScalar(value.part(part), place, visit);
  if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size(); ++i) forEachScalar(value.element(i), place, visit);
  else if (type.kind != Kind::record) {
    const std::size_t size = type.kind == Kind::boolean ? 1 : numberSize(type.number);
    visit(static_cast<std::byte*>(value.data), place, size);
    place += size;
  }
}

}  // namespace gt::python
