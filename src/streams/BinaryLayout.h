#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "streams/Shape.h"

/// Positions of a type's parts in a CDR stream, as far as they are known at compile time. Types
/// without texts and lists are written and read without checking alignment and the end of the data
/// at each number.
namespace gt::cdr {

static_assert(std::endian::native == std::endian::little);

template <typename T, std::size_t i>
using PartType = std::remove_cvref_t<decltype(Shape<T>::template part<i>(std::declval<T&>()))>;

template <typename T, std::size_t... i>
constexpr std::size_t uniformPartSize(std::index_sequence<i...>);

/// The size in bytes of the numbers in a type if all are of the same size; 0 otherwise.
template <typename T>
constexpr std::size_t uniformSize() {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::number)
    return sizeof(T);
  else if constexpr (S::kind == Kind::array)
    return uniformSize<typename S::Element>();
  else if constexpr (S::kind == Kind::record)
    return uniformPartSize<T>(std::make_index_sequence<S::partCount>{});
  else
    return 0;
}
template <typename T, std::size_t... i>
constexpr std::size_t uniformPartSize(std::index_sequence<i...>) {
  const std::size_t sizes[] = {uniformSize<PartType<T, i>>()..., 0};
  for (std::size_t k = 0; k < sizeof...(i); ++k)
    if (sizes[k] != sizes[0]) return 0;
  return sizes[0];
}

/// The least number of bytes that a value of a type takes in a stream.
template <typename T>
constexpr std::size_t leastSize() {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::number)
    return sizeof(T);
  else if constexpr (S::kind == Kind::boolean || S::kind == Kind::enumeration)
    return 1;
  else if constexpr (S::kind == Kind::text || S::kind == Kind::list)
    return 4;
  else if constexpr (S::kind == Kind::array)
    return S::count * leastSize<typename S::Element>();
  else
    return []<std::size_t... i>(std::index_sequence<i...>) {
      return (std::size_t{0} + ... + leastSize<PartType<T, i>>());
    }
  (std::make_index_sequence<S::partCount>{});
}

/// Whether fields() lists the members, all of one type, in the order in which they lie in memory.
template <typename T>
constexpr bool isOrdered();
template <typename T, std::size_t... i>
constexpr bool listedAsStored(std::index_sequence<i...>) {
  using S = Shape<T>;
  const T record{};
  if constexpr ((std::same_as<PartType<T, i>, PartType<T, 0>> && ...)) {
    const PartType<T, 0>* parts[] = {&S::template part<i>(record)...};
    for (std::size_t k = 1; k < sizeof...(i); ++k)
      if (parts[k - 1] >= parts[k]) return false;
    return isOrdered<PartType<T, 0>>();
  } else
    return false;
}

template <typename T>
constexpr bool isOrdered() {
  using S = Shape<T>;
  if constexpr (std::same_as<T, Matrix3d>)
    return false;
  else if constexpr (S::kind == Kind::array)
    return isOrdered<typename S::Element>();
  else if constexpr (S::kind != Kind::record || std::is_base_of_v<VectorShape<2>, S> ||
                     std::is_base_of_v<VectorShape<3>, S>)
    return true;
  else if constexpr (S::partCount == 0)
    return false;
  else if constexpr (requires {
                       typename std::bool_constant<listedAsStored<T>(
                           std::make_index_sequence<S::partCount>{})>;
                     })
    return listedAsStored<T>(std::make_index_sequence<S::partCount>{});
  else
    return false;
}

/// Whether a type has the same layout in memory as in the stream, so that whole blocks are copied
/// at once.
template <typename T>
constexpr bool isBlock = uniformSize<T>() > 0 && sizeof(T) == leastSize<T>() && isOrdered<T>();

/// Whether a type has one byte of which only the lowest values are valid.
template <typename T>
constexpr bool isByte = (kindOf<T> == Kind::boolean || kindOf<T> == Kind::enumeration) &&
                        sizeof(T) == 1;

/// The number of valid values of a boolean or an enumeration.
template <typename T>
constexpr std::size_t valueCount() {
  if constexpr (kindOf<T> == Kind::boolean)
    return 2;
  else
    return enumCount<T>;
}

/// Whether all bytes are valid values of a type of one byte.
template <typename T>
bool areValues(const std::byte* bytes, std::size_t count) {
  std::byte highest{0};
  for (std::size_t i = 0; i < count; ++i) highest = std::max(highest, bytes[i]);
  return std::to_integer<std::size_t>(highest) < valueCount<T>();
}

/// The first element of an array or list. The address of an array is used as that of its first
/// element, because gcc 12 merges the accessors of all arrays into one and then warns about its
/// bounds.
template <typename T>
auto* firstElement(T& sequence) {
  using S = Shape<std::remove_const_t<T>>;
  using Element = typename S::Element;
  if constexpr (S::kind == Kind::array) {
    static_assert(sizeof(T) == S::count * sizeof(Element));
    using Pointed = std::conditional_t<std::is_const_v<T>, const Element, Element>;
    return reinterpret_cast<Pointed*>(&sequence);
  } else
    return sequence.data();
}

template <typename T>
auto& elementAt(T& sequence, std::size_t i) {
  if constexpr (kindOf<std::remove_const_t<T>> == Kind::array)
    return Shape<std::remove_const_t<T>>::at(sequence, i);
  else
    return sequence[i];
}

/// Whether all values of a type have the same size, because it contains neither texts nor lists.
template <typename T>
constexpr bool isFixed() {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::text || S::kind == Kind::list)
    return false;
  else if constexpr (S::kind == Kind::array)
    return isFixed<typename S::Element>();
  else if constexpr (S::kind == Kind::record)
    return []<std::size_t... i>(std::index_sequence<i...>) {
      return (isFixed<PartType<T, i>>() && ...);
    }
  (std::make_index_sequence<S::partCount>{});
  else return true;
}

/// The size of the largest number in a type, in bytes.
template <typename T>
constexpr std::size_t alignmentOf() {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::number)
    return sizeof(T);
  else if constexpr (S::kind == Kind::array)
    return alignmentOf<typename S::Element>();
  else if constexpr (S::kind == Kind::record)
    return []<std::size_t... i>(std::index_sequence<i...>) {
      return std::max({std::size_t{1}, alignmentOf<PartType<T, i>>()...});
    }
  (std::make_index_sequence<S::partCount>{});
  else return 1;
}

constexpr std::size_t aligned(std::size_t at, std::size_t n) {
  return (at + n - 1) & ~(n - 1);
}

/// End position of a value of a fixed type that begins at `at`, in bytes.
template <typename T>
constexpr std::size_t fixedEnd(std::size_t at) {
  using S = Shape<T>;
  if constexpr (S::kind == Kind::number)
    return aligned(at, sizeof(T)) + sizeof(T);
  else if constexpr (S::kind == Kind::array) {
    if constexpr (S::count == 0)
      return at;
    else {
      // From the second on, elements begin alike: a number of the largest size lies between.
      const std::size_t second = fixedEnd<typename S::Element>(at);
      return second + (S::count - 1) * (fixedEnd<typename S::Element>(second) - second);
    }
  } else if constexpr (S::kind == Kind::record) {
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      ((at = fixedEnd<PartType<T, i>>(at)), ...);
    }
    (std::make_index_sequence<S::partCount>{});
    return at;
  } else
    return at + 1;
}

/// Begin position of a part of a record that begins at `at`, in bytes.
template <typename T, std::size_t part>
constexpr std::size_t partBegin(std::size_t at) {
  if constexpr (part == 0)
    return at;
  else
    return fixedEnd<PartType<T, part - 1>>(partBegin<T, part - 1>(at));
}

/// Whether a type is a group of values whose positions are known at compile time.
template <typename T>
constexpr bool isFixedGroup =
    (kindOf<T> == Kind::record || kindOf<T> == Kind::array) && isFixed<T>() && fixedEnd<T>(0) > 0;

/// Begin of a value of a fixed type that directly follows another one, in bytes after an aligned
/// position.
template <typename T>
constexpr std::size_t behindAnother() {
  return fixedEnd<T>(0) % alignmentOf<T>();
}

/// Calls visit.operator()<phase>(offset, element) for each element of an array until visit returns
/// false. The array begins `phase` bytes after a multiple of eight; visit gets the element's own
/// phase and its offset from the array's begin.
template <std::size_t phase, typename T, typename Visit>
bool forEachFixedElement(T& array, Visit&& visit) {
  using S = Shape<std::remove_const_t<T>>;
  using Element = typename S::Element;
  if constexpr (S::count == 0)
    return true;
  else {
    constexpr std::size_t second = fixedEnd<Element>(phase);
    constexpr std::size_t step = fixedEnd<Element>(second) - second;
    if (!visit.template operator()<phase>(std::size_t{0}, elementAt(array, 0))) return false;
    for (std::size_t i = 1; i < S::count; ++i)
      if (!visit.template operator()<second % 8>(second - phase + (i - 1) * step,
                                                 elementAt(array, i)))
        return false;
    return true;
  }
}

/// Like forEachFixedElement, for the parts of a record.
template <std::size_t phase, typename T, typename Visit>
bool forEachFixedPart(T& record, Visit&& visit) {
  using Record = std::remove_const_t<T>;
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (visit.template operator()<partBegin<Record, i>(phase) % 8>(
                partBegin<Record, i>(phase) - phase, Shape<Record>::template part<i>(record)) &&
            ...);
  }
  (std::make_index_sequence<Shape<Record>::partCount>{});
}

/// Writes a value of a fixed type to memory with enough room. The value begins `phase` bytes after
/// a multiple of eight.
template <std::size_t phase, typename T>
void putFixed(std::byte* out, const T& value) {
  constexpr Kind kind = kindOf<T>;
  const auto each = [out]<std::size_t begin>(std::size_t offset, const auto& element) {
    putFixed<begin>(out + offset, element);
    return true;
  };
  if constexpr (kind == Kind::number || isBlock<T>) {
    constexpr std::size_t gap = aligned(phase, uniformSize<T>()) - phase;
    std::memset(out, 0, gap);
    std::memcpy(out + gap, static_cast<const void*>(&value), sizeof value);
  } else if constexpr (kind == Kind::boolean || kind == Kind::enumeration)
    *out = static_cast<std::byte>(value);
  else if constexpr (kind == Kind::record)
    forEachFixedPart<phase>(value, each);
  else if constexpr (isByte<typename Shape<T>::Element>)
    std::memcpy(out, firstElement(value), Shape<T>::count);
  else
    forEachFixedElement<phase>(value, each);
}

/// Reads a value of a fixed type; all of its bytes must be present. Returns false if one of them is
/// not a valid value; a part of the value may be changed then.
template <std::size_t phase, typename T>
bool getFixed(const std::byte* in, T& value) {
  constexpr Kind kind = kindOf<T>;
  const auto each = [in]<std::size_t begin>(std::size_t offset, auto& element) {
    return getFixed<begin>(in + offset, element);
  };
  if constexpr (kind == Kind::number || isBlock<T>) {
    const std::byte* begin = in + aligned(phase, uniformSize<T>()) - phase;
    std::memcpy(static_cast<void*>(&value), begin, sizeof value);
    return true;
  } else if constexpr (kind == Kind::boolean || kind == Kind::enumeration) {
    const auto number = std::to_integer<std::uint8_t>(*in);
    if (number >= valueCount<T>()) return false;
    value = static_cast<T>(number);
    return true;
  } else if constexpr (kind == Kind::record)
    return forEachFixedPart<phase>(value, each);
  else if constexpr (isByte<typename Shape<T>::Element>) {
    if (!areValues<typename Shape<T>::Element>(in, Shape<T>::count)) return false;
    std::memcpy(firstElement(value), in, Shape<T>::count);
    return true;
  } else
    return forEachFixedElement<phase>(value, each);
}

}  // namespace gt::cdr
