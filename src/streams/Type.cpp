#include "streams/Type.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "base/Number.h"
#include "streams/NumberType.h"

namespace gt {
namespace {

template <typename N>
N load(const void* data) {
  N n;
  std::memcpy(&n, data, sizeof n);
  return n;
}

std::string rangeText(Range range) {
  return "must be from " + numberText(range.low) + " to " + numberText(range.high);
}

Error valueError(std::string what) {
  return {.what = std::move(what)};
}

template <typename N>
Result<void> setNumber(void* data, std::string_view text, Range range) {
  N n{};
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (failure == std::errc::result_out_of_range) return valueError("is too large a number");
  if (failure != std::errc{} || end != text.data() + text.size() || text.empty())
    return valueError(std::is_integral_v<N> ? "expected a whole number" : "expected a number");
  const auto v = static_cast<double>(n);
  if (range.bounds() && !(v >= range.low && v <= range.high)) return valueError(rangeText(range));
  std::memcpy(data, &n, sizeof n);
  return {};
}

std::string choices(std::span<const std::string_view> names) {
  std::string s = "expected ";
  for (std::size_t i = 0; i < names.size(); ++i) s += (i == 0 ? "" : " | ") + std::string(names[i]);
  return s;
}

/// search-for-ball is searchForBall.
std::string camelCase(std::string_view word) {
  std::string s;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (word[i] == '-' && i + 1 < word.size() && word[i + 1] >= 'a' && word[i + 1] <= 'z')
      s += static_cast<char>(word[++i] - 'a' + 'A');
    else
      s += word[i];
  return s;
}

Result<void> setEnumeration(Value v, std::string_view text) {
  const std::string name = camelCase(text);
  const auto found = std::ranges::find(v.type->names, name);
  if (found == v.type->names.end()) return valueError(choices(v.type->names));
  setOrdinal(v, found - v.type->names.begin());
  return {};
}

/// Whether values of a type can be wrong at all: most are not worth looking at.
bool isConditional(const Type& type) {
  if (type.kind == Kind::array || type.kind == Kind::list) return isConditional(type.element());
  return type.validationError ||
         std::any_of(type.parts.begin(), type.parts.end(), [](const Part& part) {
           return part.range.bounds() || isConditional(part.type());
         });
}

double asDouble(ConstValue number) {
  return withType(number.type().number, [&]<typename N>(std::type_identity<N>) {
    return static_cast<double>(load<N>(number.data()));
  });
}

Error inPart(std::string_view name, Error error) {
  error.field = std::string(name) + (error.field.empty() ? "" : "." + error.field);
  return error;
}

Result<void> checkElements(ConstValue sequence) {
  if (!isConditional(sequence.type().element())) return {};
  for (std::size_t i = 0; i < sequence.size(); ++i)
    if (auto done = checked(sequence.element(i)); !done)
      return inPart(std::to_string(i), done.error());
  return {};
}

}  // namespace

Result<void> checked(ConstValue value) {
  const Type& type = value.type();
  if (type.kind == Kind::array || type.kind == Kind::list) return checkElements(value);
  for (const Part& p : type.parts) {
    const ConstValue part = value.part(p);
    if (p.range.bounds() && part.type().kind == Kind::number) {
      const double number = asDouble(part);
      if (!(number >= p.range.low && number <= p.range.high))
        return Error{.field = std::string(p.name),
                     .what = rangeText(p.range) + " instead of " + scalarText(part)};
    }
    if (auto done = checked(part); !done) return inPart(p.name, done.error());
  }
  const std::string_view validationError =
      type.validationError ? type.validationError(value.data()) : std::string_view{};
  if (!validationError.empty()) return valueError(std::string(validationError));
  return {};
}

Result<void> finite(ConstValue value) {
  const Type& type = value.type();
  if (type.kind == Kind::number && !std::isfinite(asDouble(value)))
    return Error{.what = "is no number"};
  if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size(); ++i)
      if (auto done = finite(value.element(i)); !done)
        return inPart(std::to_string(i), done.error());
  for (const Part& p : type.parts)
    if (auto done = finite(value.part(p)); !done) return inPart(p.name, done.error());
  return {};
}

std::size_t Value::size() const {
  return type->kind == Kind::list ? type->length(data) : type->count;
}

Value Value::element(std::size_t i) const {
  return {&type->element(), type->at(data, i)};
}

Value Value::part(const Part& p) const {
  return {&p.type(), p.in(data)};
}

bool isFlat(const Type& type) {
  if (type.kind == Kind::array) return isFlat(type.element()) && type.element().kind != Kind::list;
  if (type.kind == Kind::list) return isFlat(type.element()) && width(type.element()) > 0;
  return type.kind != Kind::record || type.basic;
}

std::size_t width(const Type& type) {
  std::size_t n = 0;
  if (type.kind == Kind::array) return type.count * width(type.element());
  if (type.kind == Kind::list) return 0;
  if (type.kind != Kind::record) return 1;
  for (const Part& p : type.parts) n += width(p.type());
  return n;
}

std::int64_t ordinal(ConstValue scalar) {
  if (scalar.type().kind == Kind::boolean) return *static_cast<const bool*>(scalar.data()) ? 1 : 0;
  return withType(scalar.type().number, [&]<typename N>(std::type_identity<N>) {
    return static_cast<std::int64_t>(load<N>(scalar.data()));
  });
}

void setOrdinal(Value scalar, std::int64_t number) {
  if (scalar.type->kind == Kind::boolean) {
    *static_cast<bool*>(scalar.data) = number != 0;
    return;
  }
  withType(scalar.type->number, [&]<typename N>(std::type_identity<N>) {
    const auto n = static_cast<N>(number);
    std::memcpy(scalar.data, &n, sizeof n);
  });
}

std::string scalarText(ConstValue scalar) {
  switch (scalar.type().kind) {
    case Kind::boolean:
      return ordinal(scalar) != 0 ? "true" : "false";
    case Kind::text:
      return *static_cast<const std::string*>(scalar.data());
    case Kind::enumeration: {
      const auto n = static_cast<std::size_t>(ordinal(scalar));
      return n < scalar.type().names.size() ? std::string(scalar.type().names[n]) : "?";
    }
    default:
      return withType(scalar.type().number, [&]<typename N>(std::type_identity<N>) {
        return numberText(load<N>(scalar.data()));
      });
  }
}

Result<void> setScalar(Value scalar, std::string_view text, Range range) {
  switch (scalar.type->kind) {
    case Kind::boolean:
      if (text != "true" && text != "false") return valueError("expected true | false");
      setOrdinal(scalar, text == "true");
      return {};
    case Kind::text:
      *static_cast<std::string*>(scalar.data) = text;
      return {};
    case Kind::enumeration:
      return setEnumeration(scalar, text);
    default:
      return withType(scalar.type->number, [&]<typename N>(std::type_identity<N>) {
        return setNumber<N>(scalar.data, text, range);
      });
  }
}

}  // namespace gt
