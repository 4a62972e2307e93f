#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The kinds of streamable values. All formats support exactly these seven kinds.
enum class Kind { boolean, number, enumeration, text, array, list, record };

/// A part of a record without its type: the name, unit, description and range of its declaration.
struct PartInfo {
  std::string_view name, unit, doc;
  Range range;
};

/// Defines how a type is streamed, for every format. A type without a shape cannot be streamed.
template <typename T>
struct Shape;

template <typename T>
constexpr Kind kindOf = Shape<T>::kind;

template <>
struct Shape<bool> {
  static constexpr Kind kind = Kind::boolean;
};

template <typename T>
requires(std::integral<T> || std::same_as<T, float> || std::same_as<T, double>) struct Shape<T> {
  static constexpr Kind kind = Kind::number;
  using Number = T;
};

/// A point in time is streamed as a number of milliseconds.
template <>
struct Shape<Time> {
  static constexpr Kind kind = Kind::number;
  using Number = std::int64_t;
};
static_assert(sizeof(Time) == sizeof(std::int64_t));

template <typename E>
requires std::is_enum_v<E>
struct Shape<E> {
  static constexpr Kind kind = Kind::enumeration;
};

template <>
struct Shape<std::string> {
  static constexpr Kind kind = Kind::text;
};

template <typename T, std::size_t n>
struct Shape<std::array<T, n>> {
  static constexpr Kind kind = Kind::array;
  static constexpr std::size_t count = n;
  using Element = T;
  static constexpr auto& at(auto& array, std::size_t i) { return array[i]; }
};

template <typename E, typename T>
struct Shape<EnumArray<E, T>> {
  static constexpr Kind kind = Kind::array;
  static constexpr std::size_t count = enumCount<E>;
  using Element = T;
  using Index = E;
  static constexpr auto& at(auto& array, std::size_t i) { return array.values[i]; }
};

/// A matrix is an array of its numbers, row by row.
template <>
struct Shape<Matrix3d> {
  static constexpr Kind kind = Kind::array;
  static constexpr std::size_t count = 9;
  using Element = double;
  static auto& at(auto& matrix, std::size_t i) {
    return matrix(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
  }
};

template <typename T>
requires(!std::same_as<T, bool>) struct Shape<std::vector<T>> {
  static constexpr Kind kind = Kind::list;
  using Element = T;
};

template <Reflected T>
struct Shape<T> {
  static_assert(detail::CheckedFields<T>::value);
  static constexpr Kind kind = Kind::record;
  static constexpr std::size_t partCount = decltype(T::fields())::count;
  static constexpr bool basic = false;
  template <std::size_t i>
  static constexpr PartInfo info() {
    constexpr auto f = T::fields().template at<i>();
    return {f.name, f.unit, f.doc, f.range};
  }
  template <std::size_t i>
  static constexpr auto& part(auto& record) {
    constexpr auto member = T::fields().template at<i>().member;
    return record.*member;
  }
};

/// Eigen's vectors are records of x, y and z.
template <std::size_t n>
struct VectorShape {
  static constexpr Kind kind = Kind::record;
  static constexpr std::size_t partCount = n;
  static constexpr bool basic = true;
  template <std::size_t i>
  static constexpr PartInfo info() {
    return {std::array{"x", "y", "z"}[i], "", "", {}};
  }
  template <std::size_t i>
  static auto& part(auto& vector) {
    return vector[i];
  }
};
template <>
struct Shape<Vector2d> : VectorShape<2> {
  static constexpr std::string_view name = "Vector2d";
};
template <>
struct Shape<Vector2<int>> : VectorShape<2> {
  static constexpr std::string_view name = "Vector2i";
};
template <>
struct Shape<Vector3d> : VectorShape<3> {
  static constexpr std::string_view name = "Vector3d";
};

/// Poses are records of rotation and translation.
struct PoseShape {
  static constexpr Kind kind = Kind::record;
  static constexpr std::size_t partCount = 2;
  static constexpr bool basic = true;
  template <std::size_t i>
  static constexpr PartInfo info() {
    return {i == 0 ? "rotation" : "translation", "", "", {}};
  }
  template <std::size_t i>
  static auto& part(auto& pose) {
    if constexpr (i == 0)
      return pose.rotation;
    else
      return pose.translation;
  }
};
template <>
struct Shape<Pose2D> : PoseShape {};
template <>
struct Shape<Pose3D> : PoseShape {};

/// A type that all formats can stream.
template <typename T>
concept Streamable = requires {
  Shape<T>::kind;
};

/// Calls visit(info, part) for each part of a record, in order, until visit returns false. Returns
/// whether all calls returned true.
template <typename T, typename Visit>
constexpr bool forEachPart(T& record, Visit&& visit) {
  using S = Shape<std::remove_const_t<T>>;
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (visit(S::template info<i>(), S::template part<i>(record)) && ...);
  }
  (std::make_index_sequence<S::partCount>{});
}

}  // namespace gt
