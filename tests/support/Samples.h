#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "base/Random.h"
#include "streams/Type.h"

/// Values for the tests of the formats.
namespace gt::samples {

enum class Color { red, skyblue, green };
enum class Small : std::uint8_t { no, yes, maybe };

struct Byte4 {
  std::uint8_t a = 0, b = 1, c = 2, d = 3;

  static constexpr auto fields() {
    return Fields{field<&Byte4::a>(), field<&Byte4::b>(), field<&Byte4::c>(), field<&Byte4::d>()};
  }
};

struct Inner {
  bool flag = false;
  std::string text;
  double value = 0;

  static constexpr auto fields() {
    return Fields{field<&Inner::flag>(), field<&Inner::text>("any text"),
                  field<&Inner::value>(Unit::mm, "a length", {-100, 100})};
  }
};

/// One field of each kind of type.
struct Everything {
  bool flag = false;
  std::int8_t int8 = 0;
  std::uint8_t uint8 = 0;
  std::int16_t int16 = 0;
  std::uint16_t uint16 = 0;
  int int32 = 0;
  std::uint32_t uint32 = 0;
  std::int64_t int64 = 0;
  std::uint64_t uint64 = 0;
  float float32 = 0;
  double float64 = 0;
  Time time;
  Color color = Color::red;
  Small small = Small::no;
  std::string text;
  std::array<double, 3> doubles{};
  std::array<Small, 3> smalls{};
  std::array<Inner, 2> inners;
  std::vector<int> ints;
  std::vector<Color> colors;
  std::vector<Byte4> pixels;
  std::vector<std::string> texts;
  std::vector<Inner> list;
  std::vector<Vector3d> points;
  std::vector<Pose2D> poses;
  EnumArray<Color, double> byColor;
  EnumArray<Color, bool> lit;
  Vector2d vector2 = Vector2d::Zero();
  Vector3d vector3 = Vector3d::Zero();
  Matrix3d matrix = Matrix3d::Identity();
  Pose2D pose2;
  Pose3D pose3;
  Inner inner;

  static constexpr auto fields() {
    using E = Everything;
    return Fields{
        field<&E::flag>(),    field<&E::int8>(),    field<&E::uint8>(),   field<&E::int16>(),
        field<&E::uint16>(),  field<&E::int32>(),   field<&E::uint32>(),  field<&E::int64>(),
        field<&E::uint64>(),  field<&E::float32>(), field<&E::float64>(), field<&E::time>(Unit::ms),
        field<&E::color>(),   field<&E::small>(),   field<&E::text>(),    field<&E::doubles>(),
        field<&E::smalls>(),  field<&E::inners>(),  field<&E::ints>(),    field<&E::colors>(),
        field<&E::pixels>(),  field<&E::texts>(),   field<&E::list>(),    field<&E::points>(),
        field<&E::poses>(),   field<&E::byColor>(), field<&E::lit>(),     field<&E::vector2>(),
        field<&E::vector3>(), field<&E::matrix>(),  field<&E::pose2>(),   field<&E::pose3>(),
        field<&E::inner>()};
  }
};

/// Sets a value to a random one, with extremes among them; numbers with a range stay within it.
inline void randomize(Value value, Random& random, Range range = {}) {
  const Type& type = *value.type;
  if (type.kind == Kind::record) {
    for (const Part& p : type.parts) randomize(value.part(p), random, p.range);
  } else if (type.kind == Kind::array || type.kind == Kind::list) {
    if (type.kind == Kind::list) type.resize(value.data, random.index(5));
    for (std::size_t i = 0; i < value.size(); ++i) randomize(value.element(i), random, range);
  } else if (type.kind == Kind::text) {
    auto& text = *static_cast<std::string*>(value.data);
    text.clear();
    const auto length = random.chance(0.05) ? 5000 : random.index(8);
    for (std::size_t i = 0; i < length; ++i)
      text += std::string_view("ab \\\"\n\t\r#/[=]\xc3\xa4\0", 16)[random.index(16)];
  } else if (type.kind == Kind::boolean) {
    setOrdinal(value, random.chance(0.5));
  } else if (type.kind == Kind::enumeration) {
    setOrdinal(value, static_cast<std::int64_t>(random.index(type.names.size())));
  } else if (range.bounds()) {
    const double x = random.uniform(range.low, range.high);
    if (type.number == Number::float64)
      *static_cast<double*>(value.data) = x;
    else
      setOrdinal(value, static_cast<std::int64_t>(x));
  } else if (type.number == Number::float64) {
    using Limits = std::numeric_limits<double>;
    const double extremes[] = {Limits::quiet_NaN(),  Limits::infinity(), -Limits::infinity(), -0.0,
                               Limits::denorm_min(), Limits::max(),      Limits::lowest(),    0.1};
    *static_cast<double*>(value.data) =
        random.chance(0.5) ? extremes[random.index(8)] : std::bit_cast<double>(random());
    if (*static_cast<double*>(value.data) != *static_cast<double*>(value.data))
      *static_cast<double*>(value.data) = Limits::quiet_NaN();
  } else if (type.number == Number::float32) {
    using Limits = std::numeric_limits<float>;
    const float extremes[] = {Limits::quiet_NaN(), Limits::infinity(),   -Limits::infinity(), -0.0f,
                              Limits::max(),       Limits::denorm_min(), Limits::lowest(),    0.1f};
    *static_cast<float*>(value.data) =
        random.chance(0.5) ? extremes[random.index(8)] : static_cast<float>(random.gaussian());
  } else {
    const std::int64_t extremes[] = {std::numeric_limits<std::int64_t>::min(),
                                     std::numeric_limits<std::int64_t>::max(),
                                     -1,
                                     0,
                                     127,
                                     -128};
    setOrdinal(value, random.chance(0.5) ? extremes[random.index(6)]
                                         : static_cast<std::int64_t>(random()));
  }
}

}  // namespace gt::samples
