#include "streams/Json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "streams/Binary.h"
#include "support/Samples.h"

namespace gt {
namespace {

using samples::Everything;
using samples::Inner;

TEST(Json, WritesFieldsInOrder) {
  EXPECT_EQ(toJson(Inner{true, "a\"b", 0.1}).dump(), R"({"flag":true,"text":"a\"b","value":0.1})");
  EXPECT_EQ(toJson(Vector2d{1, 2}).dump(), R"({"x":1.0,"y":2.0})");
  EXPECT_EQ(toJson(Time{7}).dump(), "7");
  EXPECT_EQ(toJson(samples::Color::skyblue).dump(), "\"skyblue\"");
  EXPECT_EQ(toJson(0.1f).dump(), "0.1");
  EXPECT_EQ(toJson(-0.0f).dump(), "-0.0");
  EXPECT_EQ(toJson(std::numeric_limits<double>::infinity()).dump(), "null");
}

/// Infinities become null and texts that are no UTF-8 cannot be written: both are left out here.
void simplify(Value v) {
  const Type& type = *v.type;
  for (const Part& p : type.parts) simplify(v.part(p));
  if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < v.size(); ++i) simplify(v.element(i));
  if (type.kind == Kind::text) *static_cast<std::string*>(v.data) = "\"\\\n text";
  if (type.kind == Kind::number && type.number == Number::float64 &&
      std::isinf(*static_cast<double*>(v.data)))
    *static_cast<double*>(v.data) = 1e300;
  if (type.kind == Kind::number && type.number == Number::float32 &&
      std::isinf(*static_cast<float*>(v.data)))
    *static_cast<float*>(v.data) = 1e30f;
}

TEST(Json, ReadsWhatItWrote) {
  Random random{6};
  for (int i = 0; i < 200; ++i) {
    Everything value, read;
    samples::randomize(valueOf(value), random);
    simplify(valueOf(value));
    const auto json = parseJson(toJson(value).dump(), "test");
    ASSERT_TRUE(json);
    const auto result = fromJson(*json, read);
    ASSERT_TRUE(result) << result.error().text();
    std::vector<std::byte> a, b;
    encode(value, a);
    encode(read, b);
    ASSERT_EQ(a, b);
  }
}

TEST(Json, TellsWhereItIsWrong) {
  const auto errorOf = [](const char* text) {
    Inner inner{true, "old", 1};
    const auto json = parseJson(text, "test.json");
    if (!json) return json.error().text();
    const auto result = fromJson(*json, inner);
    EXPECT_EQ(inner.text, result ? inner.text : "old");
    return result ? std::string("none") : result.error().text();
  };
  EXPECT_EQ(errorOf(R"({"flag":false})"), "none");
  EXPECT_EQ(errorOf(R"({"text":"new","value":"x"})"), "value: has a value of a wrong kind");
  EXPECT_EQ(errorOf(R"({"vlaue":1})"), "vlaue: unknown name");
  EXPECT_EQ(errorOf(R"({"value":1000})"), "value: must be from -100 to 100");
  EXPECT_EQ(errorOf(R"([])"), "expected an object");
  EXPECT_EQ(errorOf("{\"x\": 1e999}"), "test.json: holds a number that is too large");
  EXPECT_EQ(errorOf("{"), "test.json: 2: is no JSON");
  EXPECT_EQ(errorOf(std::string(100000, '[').c_str()),
            "test.json: is nested too deeply, at most 100 levels");
}

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

/// Brackets in strings neither open nor close a level.
TEST(Json, RefusesWhatIsNestedTooDeeply) {
  for (const std::string name : {"", "]", "}", "[", "{", "\\\"]", "\\\\"}) {
    const auto nested = [&](std::size_t levels) {
      const std::string half = repeated("[\"" + name + "\",{\"" + name + "\":", levels / 2);
      return parseJson(half + "1" + repeated("}]", levels / 2), "");
    };
    EXPECT_TRUE(nested(100)) << name;
    ASSERT_FALSE(nested(102)) << name;
    EXPECT_EQ(nested(102).error().what, "is nested too deeply, at most 100 levels") << name;
    EXPECT_FALSE(nested(200'000)) << name;
    EXPECT_TRUE(parseJson("[" + repeated("[\"" + name + "\"],", 1000) + "1]", ""))
        << "beside each other";
  }
}

/// A key is looked for among all before it, so many of them would take long.
TEST(Json, RefusesObjectsOfTooManyMembers) {
  const auto object = [](std::size_t members) {
    std::string text = "{";
    for (std::size_t i = 0; i < members; ++i) text += '"' + std::to_string(i) + "\":1,";
    text.back() = '}';
    return parseJson(text, "");
  };
  EXPECT_EQ(object(1000)->size(), 1000u);
  ASSERT_FALSE(object(1001));
  EXPECT_EQ(object(1001).error().what, "has an object of more than 1000 members");
}

}  // namespace
}  // namespace gt
