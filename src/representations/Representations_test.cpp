#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string_view>

#include "base/File.h"
#include "representations/All.h"
#include "streams/Binary.h"
#include "streams/Config.h"
#include "streams/MessageQueue.h"
#include "streams/Schema.h"
#include "streams/Streams.h"
#include "support/Samples.h"

namespace gt {
namespace {

template <typename T>
class Representations : public testing::Test {};

TYPED_TEST_SUITE(Representations, AllRepresentations<testing::Types>);

template <typename T>
std::vector<std::byte> encoded(const T& value) {
  std::vector<std::byte> bytes;
  encode(value, bytes);
  return bytes;
}

/// Reads a value from a stream that was written by another and holds nothing else.
template <typename T>
T readFrom(In& stream) {
  T value{};
  stream >> value;
  EXPECT_TRUE(stream) << stream.error()->text();
  EXPECT_TRUE(stream.eof());
  return value;
}

TYPED_TEST(Representations, KeepTheirValuesInAllFormats) {
  Random random{1};
  for (int i = 0; i < 10; ++i) {
    TypeParam value{};
    samples::randomize(valueOf(value), random);
    const auto bytes = encoded(value);
    const auto expectSame = [&](const TypeParam& read, const char* format) {
      EXPECT_TRUE(encoded(read) == bytes) << format;
    };
    TypeParam fromBinary{}, fromConfig{};
    ASSERT_TRUE(decode(bytes, fromBinary));
    expectSame(fromBinary, "decode");
    const auto result = parseConfig(writeConfig(value), "test.cfg", fromConfig);
    ASSERT_TRUE(result) << result.error().text();
    expectSame(fromConfig, "config");
    OutBinaryMemory binary;
    OutTextMemory text;
    binary << value;
    text << value;
    EXPECT_EQ(binary.bytes(), bytes);
    InBinaryMemory inBinary{binary.bytes()};
    InTextMemory inText{text.text()};
    expectSame(readFrom<TypeParam>(inBinary), "binary");
    expectSame(readFrom<TypeParam>(inText), "text");
    MessageQueue queue{8 << 20};
    ASSERT_TRUE(queue.write({1}, value));
    queue.handleAllMessages([&](const Message& message) {
      TypeParam read{};
      // Of random values some are none that may come from outside; they are reported, but read.
      EXPECT_EQ(static_cast<bool>(message.read(read)), static_cast<bool>(checked(valueOf(value))));
      expectSame(read, "message");
    });
  }
}

TEST(Messages, RefuseFromOutsideWhatModulesCouldNotBear) {
  const auto refused = [](const auto& value) {
    auto read = value;
    const std::vector<std::byte> bytes = encoded(value);
    const auto done = Message{0, {}, bytes}.read(read);
    return done ? "" : done.error().text();
  };
  Image image;
  image.allocate();
  EXPECT_EQ(refused(image), "");
  image.pixels.pop_back();
  EXPECT_EQ(refused(image), "its pixels are not as many as its size says");
  image.info.height = -1;
  EXPECT_EQ(refused(image), "info.height: must be from 1 to 4096 instead of -1");
  LandmarksPercept landmarks;
  landmarks.numberOfFlags = 6;
  EXPECT_EQ(refused(landmarks), "");
  landmarks.numberOfFlags = 7;
  EXPECT_EQ(refused(landmarks), "numberOfFlags: must be from 0 to 6 instead of 7");
}

/// Whether a type is one of the representations or part of one.
bool contains(const Type& type, std::string_view name) {
  if (type.name == name) return true;
  if (type.element) return contains(type.element(), name);
  return std::any_of(type.parts.begin(), type.parts.end(),
                     [&](const Part& part) { return contains(part.type(), name); });
}

template <typename... T>
struct AnyContains {
  static bool ask(std::string_view name) { return (contains(typeOf<T>(), name) || ...); }
};

// Whoever adds a representation and forgets the list gets an error.
TEST(AllRepresentations, ListsWhatIsInTheFolder) {
  int found = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{"src/representations"}) {
    if (entry.path().extension() != ".h") continue;
    const auto text = readFile(entry.path());
    ASSERT_TRUE(text);
    // The structs that are not inside of another one.
    std::istringstream lines{*text};
    std::string name;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("struct ")) name = line.substr(7, line.find(' ', 7) - 7);
      if (!line.starts_with("  static constexpr auto fields()")) continue;
      EXPECT_TRUE(AllRepresentations<AnyContains>::ask(name)) << name;
      ++found;
    }
  }
  EXPECT_GT(found, 40);
}

// ROS demands it of the names of fields, and that no two are the same.
TYPED_TEST(Representations, HaveFieldsWithNamesForRos) {
  std::vector<std::string> names;
  for (const Part& part : typeOf<TypeParam>().parts) {
    const std::string name = snakeCase(part.name);
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 0) << name;
    EXPECT_TRUE(!name.empty() && name.front() >= 'a' && name.front() <= 'z') << name;
    names.push_back(name);
  }
  EXPECT_FALSE(schemaOf<TypeParam>().text.empty());
}

TEST(ObstaclesModel, NinetySectorsCoverAllDirections) {
  EXPECT_EQ(ObstaclesModel::numberOfSectors, 90);
  EXPECT_EQ(ObstaclesModel::sectorOf(-pi), 0);
  EXPECT_EQ(ObstaclesModel::sectorOf(pi), 0) << "the same direction";
  EXPECT_EQ(ObstaclesModel::sectorOf(std::nextafter(pi, 0)), 89);
  for (int i = 0; i < 90; ++i) {
    EXPECT_EQ(ObstaclesModel::sectorOf(ObstaclesModel::middleOf(i)), i);
    EXPECT_EQ(ObstaclesModel::sectorOf(ObstaclesModel::middleOf(i) + 2 * pi), i);
  }
}

}  // namespace
}  // namespace gt
