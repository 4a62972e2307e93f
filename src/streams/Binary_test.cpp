#include "streams/Binary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "streams/Streams.h"
#include "support/Samples.h"

namespace gt {
namespace {

using samples::Everything;
using testing::HasSubstr;
using Bytes = std::vector<std::byte>;

Bytes bytes(std::initializer_list<int> numbers) {
  Bytes b;
  for (const int n : numbers) b.push_back(static_cast<std::byte>(n));
  return b;
}

template <typename T>
Bytes encoded(const T& value) {
  Bytes b;
  encode(value, b);
  return b;
}

struct Aligned {
  bool first = true;
  std::uint16_t second = 0x0201;
  std::string text = "ab";
  double third = 1;
  samples::Color color = samples::Color::green;
  std::vector<std::int32_t> list{-1};
  Time time{5};

  static constexpr auto fields() {
    return Fields{field<&Aligned::first>(), field<&Aligned::second>(), field<&Aligned::text>(),
                  field<&Aligned::third>(), field<&Aligned::color>(),  field<&Aligned::list>(),
                  field<&Aligned::time>()};
  }
};
static_assert(complete<Aligned>);

struct Forgetful {
  int a = 0, b = 0;
  static constexpr auto fields() { return Fields{field<&Forgetful::a>()}; }
};
static_assert(!complete<Forgetful>);

struct Repeating {
  int a = 0, b = 0;
  static constexpr auto fields() {
    return Fields{field<&Repeating::a>(), field<&Repeating::a>().named("b")};
  }
};
static_assert(!complete<Repeating>);

struct Confusing {
  int a = 0, b = 0;
  static constexpr auto fields() {
    return Fields{field<&Confusing::a>(), field<&Confusing::b>().named("a")};
  }
};
static_assert(!complete<Confusing>);

struct Swapped {
  std::uint8_t a = 1, b = 2;
  static constexpr auto fields() { return Fields{field<&Swapped::b>(), field<&Swapped::a>()}; }
};

// Only what lies in memory as in the stream may be copied as a block.
static_assert(cdr::isBlock<samples::Byte4> && cdr::isBlock<Vector2d> && cdr::isBlock<Vector3d>);
static_assert(!cdr::isBlock<Swapped> && !cdr::isBlock<Pose2D> && !cdr::isBlock<Matrix3d>);
static_assert(!cdr::isBlock<samples::Inner> && !cdr::isBlock<bool>);

// The bytes that CDR demands, aligned from the header's end.
TEST(Binary, WritesAlignedCdr) {
  const Bytes expected = bytes({0, 1, 0, 0,                        // header
                                1, 0, 1, 2,                        // bool, uint16
                                3, 0, 0, 0, 'a', 'b', 0,           // text
                                0, 0, 0, 0, 0,                     // padding to 16
                                0, 0, 0, 0, 0,   0,   0xf0, 0x3f,  // double
                                2, 0, 0, 0, 1,   0,   0,    0,    255, 255, 255, 255,  // enum, list
                                0, 0, 0, 0, 5,   0,   0,    0,    0,   0,   0,   0});  // time at 40
  EXPECT_EQ(encoded(Aligned{}), expected);
  EXPECT_EQ(encodedSize(Aligned{}), expected.size());
}

TEST(Binary, AppendsWithAlignmentOfItsOwn) {
  Bytes b = bytes({7});
  encode(Aligned{}, b);
  EXPECT_EQ(Bytes(b.begin() + 1, b.end()), encoded(Aligned{}));
}

TEST(Binary, KeepsTheDeclaredOrder) {
  EXPECT_EQ(encoded(std::vector<Swapped>(2)), bytes({0, 1, 0, 0, 2, 0, 0, 0, 2, 1, 2, 1}));
}

TEST(Binary, WritesMatricesRowByRow) {
  Matrix3d m;
  m << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  Matrix3d read;
  const Bytes b = encoded(m);
  double second = 0;
  std::memcpy(&second, b.data() + 12, 8);
  EXPECT_EQ(second, 2);
  ASSERT_TRUE(decode(b, read));
  EXPECT_EQ(read, m);
}

TEST(Binary, ReadsWhatItWrote) {
  Random random{1};
  for (int i = 0; i < 500; ++i) {
    Everything value, read;
    samples::randomize(valueOf(value), random);
    samples::randomize(valueOf(read), random);
    const Bytes b = encoded(value);
    ASSERT_EQ(b.size(), encodedSize(value));
    const auto result = decode(b, read);
    ASSERT_TRUE(result) << result.error().text();
    ASSERT_EQ(encoded(read), b);
    ASSERT_EQ(read.text, value.text);
    ASSERT_EQ(read.pixels.size(), value.pixels.size());
  }
}

TEST(Binary, TellsWhereTheDataIsWrong) {
  const Bytes good = encoded(Aligned{});
  Aligned value;
  const auto errorOf = [&](Bytes b) {
    const auto result = decode(b, value);
    return result ? std::string("none") : result.error().text();
  };
  EXPECT_EQ(errorOf(good), "none");
  EXPECT_EQ(errorOf({}), "the data ends too early");
  EXPECT_THAT(errorOf(bytes({0, 0, 0, 0, 1})), HasSubstr("little endian"));
  Bytes bad = good;
  bad[4] = std::byte{2};
  EXPECT_EQ(errorOf(bad), "first: there is no value 2");
  bad = good;
  bad[28] = std::byte{3};
  EXPECT_EQ(errorOf(bad), "color: there is no value 3");
  bad = good;
  bad[35] = std::byte{0xff};
  EXPECT_EQ(errorOf(bad), "list: its length exceeds the data");
  bad = good;
  bad[14] = std::byte{1};
  EXPECT_EQ(errorOf(bad), "text: the text has no end");
  bad = good;
  bad.resize(bad.size() - 1);
  EXPECT_EQ(errorOf(bad), "time: the data ends too early");
  bad = good;
  bad.resize(bad.size() + 4);
  EXPECT_THAT(errorOf(bad), HasSubstr("4 bytes more"));
}

TEST(Binary, NamesThePathOfAnError) {
  std::vector<samples::Inner> list(2);
  Bytes b = encoded(list);
  b[28] = std::byte{9};
  const auto result = decode(b, list);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().text(), "1.flag: there is no value 9");
}

TEST(Binary, SurvivesTruncatedData) {
  Random random{2};
  Everything value, read;
  samples::randomize(valueOf(value), random);
  const Bytes b = encoded(value);
  for (std::size_t n = 0; n < b.size(); ++n) EXPECT_FALSE(decode(std::span{b}.first(n), read)) << n;
}

TEST(Binary, SurvivesMutatedData) {
  Random random{3};
  Everything read;
  int failures = 0;
  for (int i = 0; i < 20000; ++i) {
    Everything value;
    if (i % 100 == 0) samples::randomize(valueOf(value), random);
    Bytes b = encoded(value);
    for (int k = 0; k < 3; ++k) b[random.index(b.size())] = static_cast<std::byte>(random());
    if (!decode(b, read)) ++failures;
    encoded(read);  // What was read is valid.
  }
  EXPECT_GT(failures, 1000);
}

/// Types whose numbers lie elsewhere in the stream each time they begin elsewhere.
struct Odd {
  double number = 0;
  bool flag = false;
  static constexpr auto fields() { return Fields{field<&Odd::number>(), field<&Odd::flag>()}; }
};
struct Mixed {
  std::int32_t whole = 0;
  float part = 0;
  std::int16_t small = 0;
  samples::Color color = samples::Color::red;
  static constexpr auto fields() {
    return Fields{field<&Mixed::whole>(), field<&Mixed::part>(), field<&Mixed::small>(),
                  field<&Mixed::color>()};
  }
};
struct Turned {
  Matrix3d a = Matrix3d::Identity(), b = Matrix3d::Identity();
  static constexpr auto fields() { return Fields{field<&Turned::a>(), field<&Turned::b>()}; }
};
template <typename T>
struct Placed {
  bool before = false;
  T one;
  std::uint8_t between = 0;
  std::array<T, 5> array;
  std::vector<T> list;
  std::vector<std::array<T, 2>> pairs;
  T last;
  static constexpr auto fields() {
    using P = Placed;
    return Fields{field<&P::before>(), field<&P::one>(),   field<&P::between>(), field<&P::array>(),
                  field<&P::list>(),   field<&P::pairs>(), field<&P::last>()};
  }
};

/// What is laid out when the program is compiled is what the stream writes number by number.
template <typename T>
void expectSameLayout() {
  Random random{20};
  for (int i = 0; i < 100; ++i) {
    Placed<T> value, read;
    samples::randomize(valueOf(value), random);
    std::vector<std::byte> bytes;
    encode(value, bytes);
    OutBinaryMemory out;
    out << value;
    ASSERT_EQ(bytes, out.bytes());
    ASSERT_TRUE(decode(bytes, read));
    std::vector<std::byte> again;
    encode(read, again);
    ASSERT_EQ(again, bytes);
    for (std::size_t size = 0; size + 3 < bytes.size(); ++size)
      ASSERT_FALSE(decode(std::span{bytes}.first(size), read)) << size << " of " << bytes.size();
  }
}

TEST(Binary, LaysFixedTypesOutAsItStreamsThem) {
  expectSameLayout<Odd>();
  expectSameLayout<Mixed>();
  expectSameLayout<Turned>();
  expectSameLayout<Swapped>();
  expectSameLayout<samples::Byte4>();
  expectSameLayout<std::array<samples::Small, 3>>();
  expectSameLayout<Pose2D>();
}

TEST(Binary, TellsWhereFixedTypesAreWrong) {
  Placed<Mixed> value;
  std::vector<std::byte> bytes;
  encode(value, bytes);
  int wrong = 0;
  for (std::byte& b : bytes) {
    const std::byte good = std::exchange(b, std::byte{0xee});
    Placed<Mixed> read;
    if (const auto done = decode(bytes, read); !done) {
      wrong +=
          done.error().field.ends_with("color") && done.error().what == "there is no value 238";
      EXPECT_LT(static_cast<int>(read.one.color), 3);
    }
    b = good;
  }
  EXPECT_EQ(wrong, 7) << "of one, array and last";
}

}  // namespace
}  // namespace gt
