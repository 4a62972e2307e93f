#include "simulation/scene/ProfileTable.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "base/File.h"
#include "streams/Config.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// The numbers of a scene that profiles set, by path; those of an element and the scene's own.
std::map<std::string, double> numbersOf(SceneDescription& scene) {
  std::map<std::string, double> numbers{{"audience", scene.audience}};
  forEachProfileElement(scene, [&](const std::string& element, auto& parameters) {
    forEachField(parameters, [&](const auto& f, auto& member) {
      numbers[element + "/" + std::string{f.name}] = static_cast<double>(member);
    });
  });
  return numbers;
}

std::string pathOf(const ProfileNumber& number) {
  return (number.element.empty() ? "" : std::string{number.element} + "/") +
         std::string{number.name};
}

SceneDescription sceneOf(Profile profile) {
  SceneDescription scene;
  setProfile(scene, profile);
  return scene;
}

TEST(ProfileTable, HasEachNumberOfTheElementsOnce) {
  // What is the same in every world, or wanted by a scene.
  const std::set<std::string> others{
      "camera/brightness",  "camera/shiftCb",       "camera/shiftCr",     "camera/pixelShading",
      "camera/shadows",     "camera/lightChange",   "camera/lightPeriod", "physics/bounceRobot",
      "physics/bounceWall", "physics/deceleration", "physics/friction",   "physics/maxSpeed",
      "radio/out"};
  SceneDescription scene;
  std::set<std::string> left;
  for (const auto& [path, value] : numbersOf(scene))
    if (!others.contains(path)) left.insert(path);
  EXPECT_EQ(left.size() + others.size(), numbersOf(scene).size());
  for (const ProfileNumber& number : profileTable())
    EXPECT_EQ(left.erase(pathOf(number)), 1u) << pathOf(number);
  EXPECT_TRUE(left.empty()) << *left.begin();
}

TEST(ProfileTable, BenignIsASceneThatSaysNothing) {
  SceneDescription nothing, benign = sceneOf(Profile::benign);
  EXPECT_EQ(numbersOf(benign), numbersOf(nothing));
  EXPECT_EQ(nothing.profile, Profile::benign);
}

TEST(ProfileTable, EachProfileSetsItsNumbers) {
  for (const Profile profile : {Profile::perfect, Profile::padova, Profile::rough}) {
    SceneDescription scene = sceneOf(profile);
    EXPECT_EQ(scene.profile, profile);
    const auto numbers = numbersOf(scene);
    for (const ProfileNumber& number : profileTable())
      EXPECT_EQ(numbers.at(pathOf(number)), number.values[profile]) << pathOf(number);
  }
  EXPECT_FALSE(sceneOf(Profile::perfect).camera.colors());
}

TEST(ProfileTable, NothingIsBetterInRoughThanInPadova) {
  for (const ProfileNumber& number : profileTable())
    EXPECT_GE(number.values[Profile::rough], number.values[Profile::padova]) << pathOf(number);
}

TEST(ProfileTable, WhatAProfileSetsASceneMaySay) {
  for (const ProfileNumber& number : profileTable())
    for (const double value : number.values) {
      SceneDescription scene;
      forEachProfileElement(scene, [&](std::string_view element, auto& parameters) {
        if (element != number.element) return;
        forEachField(parameters, [&](const auto& f, auto& member) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(member)>, double>)
            if (f.name == number.name) {
              EXPECT_GE(value, f.range.low) << pathOf(number);
              EXPECT_LE(value, f.range.high) << pathOf(number);
            }
        });
      });
    }
}

TEST(ProfileTable, WhatTheSceneSaysCountsMore) {
  const std::string file = testing::TempDir() + "profile.scene";
  ASSERT_TRUE(writeFile(file,
                        "<scene audience=\"3\" profile=\"padova\"><noise slip=\"0.01\"/>"
                        "<body tilt=\"2\"/></scene>"));
  auto scene = loadScene(file);
  ASSERT_TRUE(scene) << scene.error().text();
  SceneDescription padova = sceneOf(Profile::padova);
  auto expected = numbersOf(padova);
  expected["audience"] = 3;
  expected["noise/slip"] = 0.01;
  expected["body/tilt"] = 2;
  EXPECT_EQ(numbersOf(*scene), expected);
  ASSERT_TRUE(writeFile(file, "<scene/>"));
  scene = loadScene(file);
  EXPECT_EQ(numbersOf(*scene), numbersOf(padova));
  ASSERT_TRUE(writeFile(file, "<scene profile=\"pisa\"/>"));
  scene = loadScene(file);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().field, "profile");
  std::filesystem::remove(file);
}

/// The table as docs/realism.md shows it.
std::string documentation() {
  std::string text =
      "| number | unit | perfect | benign | padova | rough | what it is | source |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  SceneDescription scene;
  for (const ProfileNumber& number : profileTable()) {
    const auto row = [&](std::string_view element, auto& parameters) {
      if (element != number.element) return;
      forEachField(parameters, [&](const auto& f, auto&) {
        if (f.name != number.name) return;
        text += fmt::format("| `{}` | {} |", pathOf(number), f.unit);
        for (const double value : number.values) text += fmt::format(" {} |", value);
        text += fmt::format(" {} | {} |\n", f.doc, number.source);
      });
    };
    row("", scene);
    forEachProfileElement(scene, row);
  }
  return text;
}

TEST(ProfileTable, IsTheDocumentedOne) {
  const std::string file = "docs/realism.md", begin = "<!-- profiles -->\n", end = "<!-- end -->";
  const auto page = readFile(file);
  ASSERT_TRUE(page);
  const auto from = page->find(begin), to = page->find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t first = from + begin.size();
  if (std::getenv("GT_WRITE_PROFILES")) {
    ASSERT_TRUE(writeFile(file, page->substr(0, first) + documentation() + page->substr(to)));
    return;
  }
  EXPECT_TRUE(page->substr(first, to - first) == documentation())
      << "write it anew with GT_WRITE_PROFILES=1";
}

}  // namespace
}  // namespace gt
