#include "simulation/sensors/FieldSensors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/File.h"
#include "simulation/Simulation.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// A post 1 m high and 100 mm wide, 1 m ahead of a table with all kinds of sensors, which turns.
constexpr const char* workbench = R"(<mujoco>
  <compiler angle="degree"/>
  <visual><headlight ambient="0.8 0.8 0.8"/></visual>
  <custom>
    <numeric name="speed/table" data="90"/>
    <numeric name="ultrasonic/sonar" data="15 3000"/>
    <numeric name="whiskerField/whiskers" data="9 3 90 30 3000"/>
    <numeric name="receptor/eye" data="2"/>
    <numeric name="facette/compound" data="16 8 180 90"/>
    SENSOR_DATA
  </custom>
  <asset><material name="red" rgba="1 0 0 1"/></asset>
  <worldbody>
    <light pos="0 0 3" dir="0 0 -1" directional="true" diffuse="0.5 0.5 0.5"/>
    <geom name="floor" type="plane" size="9 9 1"/>
    <geom name="post" type="box" group="2" size="0.05 0.05 0.5" pos="1.05 0 0.5" material="red"/>
    <body pos="0 0 0.4">
      <joint name="table" type="hinge" axis="0 0 1"/>
      <geom type="cylinder" group="2" size="0.05 0.01"/>
      <site name="front" xyaxes="0 1 0 0 0 1"/>
      <site name="flat"/>
      <site name="rim" pos="0.2 0 0"/>
    </body>
  </worldbody>
  <sensor>
    <rangefinder name="whisker" site="front" cutoff="3"/>
    <user name="sonar" objtype="site" objname="front" needstage="pos" datatype="real" dim="1"/>
    <user name="whiskers" objtype="site" objname="front" needstage="pos" datatype="real" dim="27"/>
    <user name="eye" objtype="site" objname="front" needstage="pos" datatype="real" dim="3"/>
    <user name="compound" objtype="site" objname="front" needstage="pos" datatype="real" dim="384"/>
    <gyro name="turning" site="flat"/>
    <velocimeter name="speed" site="rim"/>
    <magnetometer name="compass" site="flat"/>
    <framepos name="place" objtype="site" objname="rim"/>
    <jointpos name="angle" joint="table"/>
    SENSORS
  </sensor></mujoco>)";

class FieldSensorsTest : public testing::Test {
 protected:
  void SetUp() override {
    file_ = testing::TempDir() + "workbench.xml";
    const auto made = make("", "");
    ASSERT_TRUE(made) << made.error().text();
  }
  void TearDown() override { std::filesystem::remove(file_); }

  /// A simulation with more sensors, and more custom fields.
  Result<void> make(const std::string& sensors, const std::string& data) {
    std::string text = workbench;
    for (const auto& [key, more] :
         std::map<std::string, std::string>{{"SENSOR_DATA", data}, {"SENSORS", sensors}})
      text.replace(text.find(key), key.size(), more);
    EXPECT_TRUE(writeFile(file_, text));
    SceneDescription scene = matchScene();
    scene.field = std::filesystem::absolute(file_).string();
    scene.game.referee = false;
    scene.robots.clear();
    scene.balls.clear();
    auto made = Simulation::make(scene, 1);
    if (!made) return made.error();
    simulation_ = std::move(*made);
    return {};
  }
  std::vector<double> read(const std::string& name) {
    const auto& all = simulation_->fieldSensors().all();
    const auto found = std::ranges::find(all, name, &FieldSensors::Sensor::name);
    EXPECT_NE(found, all.end()) << name;
    return simulation_->readFieldSensor(static_cast<std::size_t>(found - all.begin()));
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / tickSeconds); ++i) simulation_->step();
  }
  void turnTo(double degrees) {
    simulation_->world().moveJoint(0, std::array{fromDegrees(degrees)});
    simulation_->step();
  }

  std::string file_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(FieldSensorsTest, AnUltrasonicSensorFindsWhatAWhiskerMisses) {
  turnTo(0);
  EXPECT_NEAR(read("whisker")[0], 1000, 0.1);
  EXPECT_NEAR(read("sonar")[0], 1000, 5) << "straight ahead";
  turnTo(10);
  EXPECT_EQ(read("whisker")[0], 3000) << "nothing within its range";
  EXPECT_NEAR(read("sonar")[0], 1020, 20) << "within its cone";
  turnTo(60);
  // The floor is 400 mm below; the lower edge of the cone meets it.
  EXPECT_NEAR(read("sonar")[0], 400 / std::sin(fromDegrees(15)), 1);
}

TEST_F(FieldSensorsTest, AWhiskerFieldShowsWhereThePostIs) {
  for (const auto& [angle, column] : {std::pair{0, 4}, {20, 6}, {-30, 1}}) {
    turnTo(angle);
    const auto distances = read("whiskers");
    ASSERT_EQ(distances.size(), 27u);
    const auto nearest = std::min_element(distances.begin() + 9, distances.begin() + 18);
    EXPECT_EQ(nearest - distances.begin() - 9, column) << angle;
    EXPECT_LT(*nearest, 1060);
  }
  // The lowest row looks 10 degrees down, and there is nothing but the floor beside the post.
  EXPECT_NEAR(read("whiskers")[26], 400 / std::sin(fromDegrees(10)), 1);
}

TEST_F(FieldSensorsTest, AReceptorMeasuresTheColorAhead) {
  turnTo(0);
  EXPECT_GT(read("eye")[2], 160) << "red";
  turnTo(45);
  EXPECT_LT(read("eye")[2], 140) << "the background";
}

TEST_F(FieldSensorsTest, AFacetteSeesAllAroundWithEqualAngles) {
  turnTo(0);
  const auto channels = read("compound");
  ASSERT_EQ(channels.size(), 3u * 16 * 8);
  // The post is 5.7 degrees wide, on both sides of the middle: less than a pixel of 11.25 degrees.
  turnTo(180. / 16 / 2);
  const auto turned = read("compound");
  const auto cr = [&](const std::vector<double>& image, std::size_t x, std::size_t y) {
    return image[3 * (16 * y + x) + 2];
  };
  EXPECT_GT(cr(turned, 8, 4), 160);
  EXPECT_LT(cr(turned, 7, 4), 140);
  EXPECT_LT(cr(turned, 9, 4), 140);
}

TEST_F(FieldSensorsTest, MotionIsFeltAndTheCompassShowsTheDirection) {
  simulation_->actuators().find("table")->command[0] = 0.5;
  run(1);
  EXPECT_NEAR(read("turning")[2], 45, 0.1) << "deg/s about the vertical axis";
  EXPECT_NEAR(read("turning")[0], 0, 0.01);
  EXPECT_NEAR(read("speed")[1], 200 * fromDegrees(45), 1) << "sideways at the rim";
  EXPECT_NEAR(read("compass")[0], 45, 0.1);
  EXPECT_NEAR(read("angle")[0], fromDegrees(45), 1e-3) << "in rad, as MuJoCo measures it";
  EXPECT_NEAR(read("place")[0], 0.2 * std::cos(fromDegrees(45)), 1e-3) << "in m";
}

TEST_F(FieldSensorsTest, UnknownSensorsAreRefused) {
  auto made = make("<force name=\"push\" site=\"rim\"/>", "");
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().field, "push");
  EXPECT_EQ(made.error().file, std::filesystem::absolute(file_).string());
  made = make(
      "<user name=\"sixth\" objtype=\"site\" objname=\"rim\" needstage=\"pos\" datatype=\"real\" "
      "dim=\"1\"/>",
      "");
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().what.find("ultrasonic/"), std::string::npos);
  made = make(
      "<user name=\"sixth\" objtype=\"site\" objname=\"rim\" needstage=\"pos\" datatype=\"real\" "
      "dim=\"1\"/>",
      "<numeric name=\"ultrasonic/sixth\" data=\"10 500\"/>");
  EXPECT_TRUE(made) << made.error().text();
}

}  // namespace
}  // namespace gt
