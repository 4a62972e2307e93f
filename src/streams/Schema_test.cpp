#include "streams/Schema.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/Samples.h"

namespace gt {
namespace {

using testing::HasSubstr;

enum class Mode { off, slowBlink };

struct Light {
  Mode mode = Mode::off;
  double brightness = 1;
  EnumArray<Mode, int> counts;

  static constexpr auto fields() {
    return Fields{field<&Light::mode>(),
                  field<&Light::brightness>(Unit::cd, "of the lamp", {0, 1.5}),
                  field<&Light::counts>()};
  }
};

struct Lamp {
  Time lastSeen;
  Vector2d position = Vector2d::Zero();
  std::vector<Light> lights;
  std::array<Pose2D, 2> poses;
  std::vector<std::vector<int>> nested;

  static constexpr auto fields() {
    return Fields{field<&Lamp::lastSeen>(Unit::ms), field<&Lamp::position>(),
                  field<&Lamp::lights>(), field<&Lamp::poses>(), field<&Lamp::nested>()};
  }
};

TEST(Schema, DescribesAMessageInTheLanguageOfRos) {
  const std::string line = std::string(80, '=') + "\n";
  const Schema schema = schemaOf<Lamp>();
  EXPECT_EQ(schema.name, "gt2003_msgs/msg/Lamp");
  const std::string begin =
      "int64 last_seen  # ms\n"
      "gt2003_msgs/Vector2d position\n"
      "gt2003_msgs/Light[] lights\n"
      "gt2003_msgs/Pose2D[2] poses\n";
  EXPECT_EQ(schema.text.substr(0, begin.size()), begin);
  EXPECT_THAT(schema.text, HasSubstr(line +
                                     "MSG: gt2003_msgs/Light\n"
                                     "uint8 MODE_OFF=0\n"
                                     "uint8 MODE_SLOW_BLINK=1\n"
                                     "uint8 mode\n"
                                     "float64 brightness  # cd; of the lamp; from 0 to 1.5\n"
                                     "int32[2] counts  # of off slowBlink\n" +
                                     line));
  EXPECT_THAT(schema.text, HasSubstr("MSG: gt2003_msgs/Pose2D\n"
                                     "float64 rotation\n"
                                     "gt2003_msgs/Vector2d translation\n"));
  EXPECT_THAT(schema.text, HasSubstr("MSG: gt2003_msgs/ListOfInt32\nint32[] values\n"));
  std::size_t count = 0;
  for (auto at = schema.text.find("MSG: gt2003_msgs/Vector2d"); at != std::string::npos;
       at = schema.text.find("MSG: gt2003_msgs/Vector2d", at + 1))
    ++count;
  EXPECT_EQ(count, 1u);
}

TEST(Schema, HasAnIdThatChangesWithTheFields) {
  EXPECT_EQ(schemaOf<Lamp>().id(), schemaOf<Lamp>().id());
  EXPECT_NE(schemaOf<Lamp>().id(), schemaOf<Light>().id());
}

TEST(Schema, SpellsNamesAsRosDoes) {
  EXPECT_EQ(snakeCase("lastSeen"), "last_seen");
  EXPECT_EQ(snakeCase("xGroundline"), "x_groundline");
  EXPECT_EQ(snakeCase("psd"), "psd");
  EXPECT_EQ(snakeCase("timeUTC"), "time_utc");
  EXPECT_EQ(snakeCase("LEDRequest"), "led_request");
  EXPECT_EQ(snakeCase("legFR1"), "leg_fr1");
  EXPECT_EQ(snakeCase("a__b"), "a_b");
}

TEST(Schema, KnowsImages) {
  EXPECT_EQ(schemaOf<CompressedImage>().name, "sensor_msgs/msg/CompressedImage");
  EXPECT_EQ(RosTime::of(Time{12345}).sec, 12);
  EXPECT_EQ(RosTime::of(Time{12345}).nanosec, 345'000'000u);
}

}  // namespace
}  // namespace gt
