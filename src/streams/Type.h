#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "streams/Shape.h"

namespace gt {

/// The representation of a number in memory.
enum class Number { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

constexpr std::size_t numberSize(Number number) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(number)];
}

struct Type;
using TypeFunction = const Type& (*)();

/// A part of a record: its declaration and its position in memory.
struct Part : PartInfo {
  TypeFunction type;
  void* (*in)(void* record);
};

/// A run-time description of a type, for formats that need no template for each type (text, config,
/// JSON, schemas, access by path). Made from the Shape of a type by typeOf().
struct Type {
  Kind kind = Kind::number;
  std::string_view name;                         ///< Without namespaces.
  bool basic = false;                            ///< Whether it is a record of the base library,
                                                 ///< like Vector2d.
  Number number = Number::int8;                  ///< Representation of a number or enumeration.
  std::span<const std::string_view> names;       ///< Names of an enumeration's values.
  std::span<const std::string_view> indexNames;  ///< Names of an array's elements; empty if they
                                                 ///< have none.
  std::vector<Part> parts;                       ///< Parts of a record.
  std::string_view (*validationError)(const void*) = nullptr;  ///< Check of a record; null if it
                                                               ///< has none.
  TypeFunction element = nullptr;                              ///< Type of an array's or list's
                                                               ///< elements.
  std::size_t count = 0;                                       ///< Number of an array's elements.
  void* (*at)(void*, std::size_t) = nullptr;                   ///< Accesses an element of an array
                                                               ///< or list.
  std::size_t (*length)(const void*) = nullptr;                ///< Number of a list's elements.
  void (*resize)(void*, std::size_t) = nullptr;                ///< Changes the number of a list's
                                                               ///< elements.
};

/// A value whose type is known at run time only. Does not own the value.
struct Value {
  const Type* type = nullptr;
  void* data = nullptr;

  /// Number of elements of an array or list.
  std::size_t size() const;
  Value element(std::size_t i) const;
  /// A part of a record.
  Value part(const Part& p) const;
};

/// A read-only value whose type is known at run time only.
class ConstValue {
 public:
  ConstValue(const Type& type, const void* data) : value_{&type, const_cast<void*>(data)} {}
  ConstValue(Value value) : value_{value} {}

  const Type& type() const { return *value_.type; }
  const void* data() const { return value_.data; }
  std::size_t size() const { return value_.size(); }
  ConstValue element(std::size_t i) const { return value_.element(i); }
  ConstValue part(const Part& p) const { return value_.part(p); }

 private:
  Value value_;
};

namespace detail {

template <typename N>
constexpr Number numberOf() {
  if constexpr (std::same_as<N, float>)
    return Number::float32;
  else if constexpr (std::same_as<N, double>)
    return Number::float64;
  else {
    constexpr int width = sizeof(N) == 1 ? 0 : sizeof(N) == 2 ? 1 : sizeof(N) == 4 ? 2 : 3;
    return static_cast<Number>(2 * width + (std::is_unsigned_v<N> ? 1 : 0));
  }
}

template <typename T, std::size_t i>
Part makePart();
template <typename T>
Type makeType();

}  // namespace detail

/// The type of a streamable C++ type.
template <Streamable T>
const Type& typeOf() {
  static const Type type = detail::makeType<T>();
  return type;
}

template <Streamable T>
Value valueOf(T& object) {
  return {&typeOf<T>(), &object};
}
template <Streamable T>
ConstValue valueOf(const T& object) {
  return {typeOf<T>(), &object};
}

namespace detail {

template <typename T, std::size_t i>
Part makePart() {
  using S = Shape<T>;
  using Member = std::remove_reference_t<decltype(S::template part<i>(std::declval<T&>()))>;
  return {S::template info<i>(), &typeOf<Member>,
          [](void* record) -> void* { return &S::template part<i>(*static_cast<T*>(record)); }};
}

template <typename T>
void describeSequence(Type& type) {
  using S = Shape<T>;
  type.element = &typeOf<typename S::Element>;
  if constexpr (S::kind == Kind::array) {
    type.count = S::count;
    type.at = [](void* array, std::size_t i) -> void* {
      return &S::at(*static_cast<T*>(array), i);
    };
    if constexpr (requires { typename S::Index; }) type.indexNames = enumNames<typename S::Index>;
  } else {
    type.at = [](void* list, std::size_t i) -> void* { return &(*static_cast<T*>(list))[i]; };
    type.length = [](const void* list) { return static_cast<const T*>(list)->size(); };
    type.resize = [](void* list, std::size_t n) { static_cast<T*>(list)->resize(n); };
  }
}

template <typename T>
Type makeType() {
  using S = Shape<T>;
  Type type;
  type.kind = S::kind;
  if constexpr (requires { S::name; })
    type.name = S::name;
  else
    type.name = typeName<T>();
  if constexpr (S::kind == Kind::number)
    type.number = numberOf<typename S::Number>();
  else if constexpr (S::kind == Kind::enumeration) {
    type.number = numberOf<std::underlying_type_t<T>>();
    type.names = enumNames<T>;
  } else if constexpr (S::kind == Kind::array || S::kind == Kind::list)
    describeSequence<T>(type);
  else if constexpr (S::kind == Kind::record) {
    type.basic = S::basic;
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      type.parts = {makePart<T, i>()...};
    }
    (std::make_index_sequence<S::partCount>{});
    if constexpr (requires(const T& record) { record.validationError(); })
      type.validationError = [](const void* record) -> std::string_view {
        return static_cast<const T*>(record)->validationError();
      };
  }
  return type;
}

}  // namespace detail

/// Whether a type is written on one line of a config file: scalars, texts, the base library's
/// records, and arrays and lists of these.
bool isFlat(const Type& type);

/// The number of scalars in a flat value that holds no list.
std::size_t width(const Type& type);

/// Writes a scalar (boolean, number, enumeration or text) as text: numbers with the fewest digits
/// that read back to the same bits, enumerations by name.
std::string scalarText(ConstValue scalar);

/// Sets a scalar from text. If the text is not a valid value or is out of the range, returns an
/// error with the expected values and leaves the scalar unchanged.
Result<void> setScalar(Value scalar, std::string_view text, Range range = {});

/// Checks whether a value is valid: each number must lie in its field's range, and no record may
/// have a validation error. A record reports one by `std::string_view validationError() const`,
/// which returns an empty text if the record is valid. Use it for all data from outside, where it
/// enters the program. The error's field is the path.
Result<void> checked(ConstValue value);

/// Checks whether all numbers in a value are finite. The error's field is the path of one that is
/// not.
Result<void> finite(ConstValue value);

/// Reads and writes the number of an enumeration's value, or 0 and 1 of a boolean.
std::int64_t ordinal(ConstValue scalar);
void setOrdinal(Value scalar, std::int64_t number);

}  // namespace gt
