#include "foxglove/FoxgloveMessages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foxglove/FoxgloveRequest.h"

namespace gt::foxglove {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Drawing drawn(ElementType type, std::vector<Vector2d> points, double size = 0) {
  return {"key", DrawingSpace::field, {{type, std::move(points), size, colors::red, 2, "text"}}};
}

/// The area of all triangles in mm^2.
double area(const SceneEntity& entity) {
  double sum = 0;
  for (const Triangles& triangles : entity.triangles)
    for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3) {
      const Point3 &a = triangles.points[triangles.indices[i]],
                   &b = triangles.points[triangles.indices[i + 1]],
                   &c = triangles.points[triangles.indices[i + 2]];
      sum += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
  return 1e6 * sum;
}

double length(const SceneEntity& entity) {
  double sum = 0;
  for (const Lines& lines : entity.lines)
    for (std::size_t i = 0; i + 1 < lines.points.size(); i += 2)
      sum += 1000 * std::hypot(lines.points[i + 1].x - lines.points[i].x,
                               lines.points[i + 1].y - lines.points[i].y);
  return sum;
}

SceneEntity entity(const Drawing& drawing) {
  return sceneEntity(drawing, {}, "field");
}

TEST(FoxgloveMessages, AreasAreFilledWhateverTheirShape) {
  const std::vector<Vector2d> arrowhead{{0, 0}, {100, 50}, {0, 100}, {50, 50}};
  EXPECT_NEAR(area(entity(drawn(ElementType::area, arrowhead))), 2500, 1e-6);
  const std::vector<Vector2d> comb{{0, 0},   {50, 0},  {50, 50}, {40, 10},
                                   {30, 50}, {20, 10}, {10, 50}, {0, 10}};
  double expected = 0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const Vector2d &a = comb[i], &b = comb[(i + 1) % comb.size()];
    expected += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  EXPECT_NEAR(area(entity(drawn(ElementType::area, comb))), expected, 1e-6);
  EXPECT_NEAR(area(entity(drawn(ElementType::area, {comb.rbegin(), comb.rend()}))), expected, 1e-6);
  EXPECT_EQ(area(entity(drawn(ElementType::area, {{0, 0}, {1, 1}}))), 0);
}

TEST(FoxgloveMessages, ElementsHaveTheirSizes) {
  EXPECT_NEAR(area(entity(drawn(ElementType::disk, {{1000, 0}}, 100))), pi * 100 * 100, 300);
  EXPECT_NEAR(area(entity(drawn(ElementType::point, {{1000, 0}}, 10))), pi * 10 * 10, 35);
  EXPECT_NEAR(length(entity(drawn(ElementType::circle, {{1000, 0}}, 100))), 2 * pi * 100, 2);
  EXPECT_NEAR(area(entity(drawn(ElementType::sector, {{0, 0}, {0, 100}, {-100, 0}}))),
              pi * 100 * 100 / 4, 100);
  EXPECT_NEAR(length(entity(drawn(ElementType::polygon, {{0, 0}, {30, 0}, {30, 40}}))), 120, 1e-6);
  EXPECT_NEAR(length(entity(drawn(ElementType::path, {{0, 0}, {30, 0}, {30, 40}}))), 70, 1e-6);
  EXPECT_NEAR(length(entity(drawn(ElementType::line, {{0, 0}, {30, 40}}))), 50, 1e-6);
  EXPECT_GT(length(entity(drawn(ElementType::arrow, {{0, 0}, {30, 40}}))), 60);
  EXPECT_NEAR(length(entity(drawn(ElementType::ellipse, {{0, 0}, {100, 0}, {0, 100}}))),
              2 * pi * 100, 2);
  EXPECT_EQ(entity(drawn(ElementType::text, {{0, 0}}, 70)).texts.at(0).fontSize, 0.07);
}

// A robot elsewhere may send anything.
TEST(FoxgloveMessages, ElementsWithoutTheirPointsAreLeftOut) {
  for (std::size_t i = 0; i < enumCount<ElementType>; ++i)
    for (std::size_t points = 0; points < 3; ++points) {
      const Drawing drawing =
          drawn(static_cast<ElementType>(i), std::vector<Vector2d>(points, {1, 2}), 10);
      const SceneEntity inSpace = entity(drawing);
      const ImageAnnotations onImage = imageAnnotations(drawing, {});
      if (points > 0) continue;
      EXPECT_TRUE(inSpace.lines.empty() && inSpace.triangles.empty() && inSpace.texts.empty());
      EXPECT_TRUE(onImage.points.empty() && onImage.circles.empty() && onImage.texts.empty());
    }
}

TEST(FoxgloveMessages, HaveThePublicSchemas) {
  const Schema schema = SceneUpdate::schema();
  EXPECT_EQ(schema.name, "foxglove_msgs/msg/SceneUpdate");
  EXPECT_THAT(schema.text, HasSubstr("builtin_interfaces/Time timestamp\nstring frame_id\n"));
  EXPECT_THAT(schema.text, Not(HasSubstr("gt2003")));
  EXPECT_THAT(ImageAnnotations::schema().text, HasSubstr("foxglove_msgs/Point2[] points"));
}

TEST(FoxgloveParameter, IsJsonAndTextAgain) {
  struct Case {
    const char *words, *value, *type;
  };
  for (const auto& [words, value, type] : std::vector<Case>{
           {"1", "1", "float64"},
           {"1e-09", "1e-09", "float64"},
           {"-7", "-7", "float64"},
           {"inf", "\"inf\"", ""},
           {"true", "true", ""},
           {"always", "\"always\"", ""},
           {"\"\"", "\"\"", ""},
           {"\"a b\"", "\"a b\"", ""},
           {"\"say \\\"q\\\"\"", "\"say \\\"q\\\"\"", ""},
           {"1 2.5", "[1,2.5]", "float64_array"},
           {"", "[]", ""},
           {"a \"b c\"", "[\"a\",\"b c\"]", ""},
           {"1 true", "[1,true]", ""},
       }) {
    const Json json = parameterJson("red1.x", words);
    EXPECT_EQ(json["name"], "red1.x");
    EXPECT_EQ(json["value"].dump(), value) << words;
    EXPECT_EQ(json.value("type", ""), type) << words;
    const auto again = parameterText(json["value"]);
    ASSERT_TRUE(again) << words;
    EXPECT_EQ(*again, words);
  }
  EXPECT_EQ(parameterJson("red1.x", "\"a")["value"], "\"a") << "of a robot that writes otherwise";
}

TEST(FoxgloveParameter, IsNoObjectAndNoListOfLists) {
  for (const char* wrong : {"null", "{}", "[[1]]", "[null]", "[1,{}]"})
    EXPECT_FALSE(parameterText(*parseJson(wrong, ""))) << wrong;
}

}  // namespace
}  // namespace gt::foxglove
