#include "simulation/objects/SceneTree.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "simulation/objects/TestChaos.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// A field with a door, a lift, a drone, a car, sensors and emitters.
class WorkshopTest : public testing::Test {
 protected:
  void SetUp() override {
    path_ = testing::TempDir() + "workshop" + std::to_string(getpid()) + ".xml";
    std::ofstream{path_} << R"(<mujoco>
      <compiler angle="degree"/>
      <custom>
        <numeric name="speed/door" data="45"/>
        <numeric name="speed/lift" data="200"/>
        <numeric name="speed/drone" data="100 200 300 90 90 90"/>
        <numeric name="vehicle/car" data="500 30 200"/>
      </custom>
      <worldbody>
        <light name="lamp" pos="0 0 3" dir="0 0 -1" diffuse="0.5 0.5 0.5"/>
        <geom name="floor" type="plane" size="5 5 1"/>
        <geom name="post" type="box" group="2" size="0.05 0.05 0.2" pos="0 2 0.2"/>
        <body pos="-2 0 0.3">
          <joint name="door" type="hinge" axis="0 0 1" limited="true" range="-90 120"/>
          <geom name="leaf" type="box" group="2" size="0.3 0.02 0.3" pos="0.3 0 0"/>
        </body>
        <body pos="-2 2 0.3">
          <joint name="lift" type="slide" axis="0 0 1" limited="true" range="0 0.5"/>
          <geom type="box" group="2" size="0.2 0.2 0.02" mass="1"/>
          <site name="top"/>
        </body>
        <body name="drone" pos="2 2 1">
          <freejoint name="drone"/>
          <geom type="sphere" group="2" size="0.1"/>
        </body>
        <body name="car" pos="0 0 0.1">
          <freejoint name="car"/>
          <geom type="box" group="2" size="0.15 0.1 0.05"/>
          <site name="front" pos="0.15 0 0" zaxis="1 0 0"/>
        </body>
      </worldbody>
      <sensor>
        <rangefinder name="whisker" site="front" cutoff="3"/>
        <touch name="bumper" site="front"/>
        <accelerometer name="inertia" site="top" noise="0.5"/>
      </sensor></mujoco>)";
    SceneDescription scene = matchScene();
    scene.field = path_;
    scene.game.referee = false;
    scene.robots.resize(1);
    scene.robots[0].x = -3000;
    scene.balls.clear();
    auto made = Simulation::make(scene, 1);
    ASSERT_TRUE(made) << made.error().text();
    simulation_ = std::move(*made);
    tree_ = std::make_unique<SceneTree>(*simulation_);
  }
  void TearDown() override { std::remove(path_.c_str()); }

  std::string get(const std::string& path) {
    const auto value = tree_->get(path);
    EXPECT_TRUE(value) << value.error().text();
    return value ? *value : "";
  }
  std::vector<double> numbers(const std::string& path) {
    std::istringstream text{get(path)};
    return {std::istream_iterator<double>{text}, {}};
  }
  void set(const std::string& path, const std::string& value) {
    const auto done = tree_->set(path, value);
    EXPECT_TRUE(done) << done.error().text();
  }
  void run(double seconds) {
    for (int i = 0; i < std::lround(seconds / tickSeconds); ++i) simulation_->step();
  }

  std::string path_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneTree> tree_;
};

TEST_F(WorkshopTest, TheFourKindsOfActuatorsMove) {
  for (const char* fidelity : {"kinematic", "dynamic"}) {
    SetUp();
    set("fidelity", fidelity);
    set("actuators/door", "1");
    set("actuators/lift", "0.5");
    set("actuators/drone", "1 0 0 0 0 1");
    set("actuators/car", "0.4 0");
    run(1);
    EXPECT_NEAR(numbers("actuators/door/where")[0], 45, 0.01) << fidelity;
    EXPECT_NEAR(numbers("actuators/lift/where")[0], 100, 0.01);
    // A quarter of a circle of radius v / w.
    const double radius = 100 / (pi / 2);
    EXPECT_NEAR(numbers("actuators/drone/position")[0], 2000 + radius, 1);
    EXPECT_NEAR(numbers("actuators/drone/position")[1], 2000 + radius, 1);
    EXPECT_NEAR(numbers("actuators/drone/position")[2], 1000, 0.01);
    EXPECT_NEAR(numbers("actuators/car/position")[0], 200, 0.1);
    EXPECT_EQ(get("actuators/car/executed"), "true");
    // Steering: a circle of radius base / tan(angle).
    set("actuators/car", "0.4 1");
    run(1);
    const double circle = 200 / std::tan(fromDegrees(30)), angle = 200 / circle;
    EXPECT_NEAR(numbers("actuators/car/position")[0], 200 + circle * std::sin(angle), 2);
    EXPECT_NEAR(numbers("actuators/car/position")[1], circle * (1 - std::cos(angle)), 2);
  }
}

TEST_F(WorkshopTest, SensorsMeasure) {
  set("field/post", "1002.3 0 200");
  set("sensors/inertia/noise", "0");
  run(0.1);
  EXPECT_NEAR(numbers("sensors/whisker")[0], 802.3, 0.1);
  EXPECT_EQ(get("sensors/bumper"), "0");
  EXPECT_NEAR(numbers("sensors/inertia")[2], 9810, 0.1);
  set("actuators/car", "1 0");
  run(0.8);
  EXPECT_NEAR(numbers("sensors/whisker")[0], 402.3, 0.1);
  run(1.2);
  EXPECT_EQ(get("actuators/car/executed"), "false");
  EXPECT_EQ(get("sensors/bumper"), "1");
  EXPECT_LT(numbers("sensors/whisker")[0], 5);
  EXPECT_LT(numbers("actuators/car/position")[0], 803);
  set("actuators/car", "-1 0");
  run(0.1);
  EXPECT_EQ(get("actuators/car/executed"), "true");
  // The lift's start is felt.
  set("actuators/lift", "1");
  run(tickSeconds);
  EXPECT_NEAR(numbers("sensors/inertia")[2], 9810 + 200 / tickSeconds, 1);
  set("actuators/lift", "0");
  set("sensors/inertia/noise", "500");
  double squares = 0;
  for (int i = 0; i < 500; ++i) {
    run(tickSeconds);
    if (i >= 5) squares += std::pow(numbers("sensors/inertia")[0], 2);
  }
  EXPECT_NEAR(std::sqrt(squares / 495), 500, 60);
}

TEST_F(WorkshopTest, NothingGoesThroughTheFloor) {
  set("actuators/drone", "0 0 -1 0 0 0");
  run(6);
  EXPECT_NEAR(numbers("actuators/drone/position")[2], 100, 0.3) << "its radius above the floor";
  EXPECT_EQ(get("actuators/drone/executed"), "false");
  set("actuators/drone", "0 0 1 0 0 0");
  run(0.48);
  EXPECT_NEAR(numbers("actuators/drone/position")[2], 100 + 0.48 * 300, 0.5);
  EXPECT_EQ(get("actuators/drone/executed"), "true");
}

TEST_F(WorkshopTest, JointsStopAtTheirLimits) {
  set("actuators/lift", "1");
  run(3);
  EXPECT_NEAR(numbers("actuators/lift/where")[0], 500, 0.01);
  EXPECT_EQ(get("actuators/lift/executed"), "false");
}

TEST_F(WorkshopTest, EmittersShineAsTheyAreTold) {
  EXPECT_EQ(get("emitters/lamp"), "1");
  set("emitters/lamp", "0.5");
  EXPECT_FLOAT_EQ(simulation_->world().model().light_diffuse[0], 0.25f);
  set("emitters/ambient", "0.1 0.2 0.3");
  EXPECT_EQ(get("emitters/ambient"), "0.1 0.2 0.3");
}

/// Opens a door when a car comes near.
class DoorKeeper : public SceneController {
 public:
  void control(Simulation& simulation) override {
    ++ticks;
    simulation.actuators().find("door")->command[0] = ticks > 10 ? 1 : 0;
  }
  int ticks = 0;
};

TEST_F(WorkshopTest, SeveralControllersShareTheScene) {
  auto first = std::make_unique<DoorKeeper>();
  DoorKeeper* keeper = first.get();
  simulation_->add(std::move(first));
  simulation_->add(std::make_unique<DoorKeeper>());
  run(1);
  EXPECT_EQ(keeper->ticks, 125);
  EXPECT_NEAR(numbers("actuators/door/where")[0], 45 * (125 - 10) / 125., 0.01);
}

class MatchTree : public testing::Test {
 protected:
  void SetUp() override {
    SceneDescription scene = matchScene();
    scene.game.referee = false;
    auto made = Simulation::make(scene, 1);
    ASSERT_TRUE(made);
    simulation_ = std::move(*made);
    tree_ = std::make_unique<SceneTree>(*simulation_);
  }
  std::string get(const std::string& path) {
    const auto value = tree_->get(path);
    return value ? *value : value.error().text();
  }
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneTree> tree_;
};

TEST_F(MatchTree, RobotsAndBallsAreMovedThrownAndPutBack) {
  for (const char* fidelity : {"kinematic", "dynamic"}) {
    ASSERT_TRUE(tree_->set("fidelity", fidelity));
    ASSERT_TRUE(tree_->set("robots/red2", "-900 300 90"));
    ASSERT_TRUE(tree_->set("balls/0", "400 -200"));
    for (int i = 0; i < 3; ++i) simulation_->step();
    const RobotBody& robot = simulation_->world().robot(1);
    EXPECT_LT((robot.pose.translation - Vector2d{-900, 300}).norm(), 10) << fidelity;
    EXPECT_NEAR(robot.pose.rotation, pi / 2, 0.02);
    EXPECT_LT((simulation_->world().ball(0).position - Vector2d{400, -200}).norm(), 1);
    ASSERT_TRUE(tree_->set("robots/red2/posture", "onLeftSide"));
    for (int i = 0; i < 50; ++i) simulation_->step();
    EXPECT_EQ(get("robots/red2/posture"), "onLeftSide");
    EXPECT_LT(robot.specificForce.y(), -8000);
    ASSERT_TRUE(tree_->set("robots/red2/posture", "standing"));
    for (int i = 0; i < 50; ++i) simulation_->step();
    EXPECT_EQ(get("robots/red2/posture"), "standing") << fidelity;
  }
}

TEST_F(MatchTree, SwitchesRadioCameraAndGameAreSet) {
  ASSERT_TRUE(tree_->set("robots/blue1/switches/headFront", "true"));
  EXPECT_TRUE(simulation_->sensors(4).isPressed(Switch::headFront));
  ASSERT_TRUE(tree_->set("robots/blue1/radio", "false"));
  EXPECT_TRUE(simulation_->radio().isCut(4));
  ASSERT_TRUE(tree_->set("robots/blue1/camera/blur", "0.25"));
  EXPECT_EQ(simulation_->camera(4).blur, 0.25);
  EXPECT_EQ(simulation_->camera(3).blur, matchScene().camera.blur);
  ASSERT_TRUE(tree_->set("radio/loss", "0.5"));
  EXPECT_EQ(simulation_->radio().parameters().loss, 0.5);
  ASSERT_TRUE(tree_->set("rules/illegalDefender", "0"));
  EXPECT_EQ(simulation_->referee().rules().illegalDefender, 0);
  ASSERT_TRUE(tree_->set("game/state", "set"));
  EXPECT_EQ(simulation_->referee().state(), GameState::set);
  ASSERT_TRUE(tree_->set("robots/blue2/penalty", "obstruction"));
  EXPECT_EQ(simulation_->referee().dataFor(5).state, GameState::penalized);
  ASSERT_TRUE(tree_->set("robots/red1/joints/headPan", "30"));
  EXPECT_EQ(get("robots/red1/joints/headPan"), "30");
}

TEST_F(MatchTree, WrongPathsAndValuesChangeNothing) {
  EXPECT_FALSE(tree_->get("robots/green1"));
  EXPECT_FALSE(tree_->set("robots/red1/height", "100"));
  EXPECT_FALSE(tree_->set("robots/red1", "100"));
  EXPECT_FALSE(tree_->set("robots/red1", "100 nan"));
  EXPECT_FALSE(tree_->set("robots/red1", "1e30 0"));
  EXPECT_FALSE(tree_->set("robots/red1/posture", "upsideDown"));
  EXPECT_FALSE(tree_->set("radio/loss", "2"));
  EXPECT_EQ(simulation_->radio().parameters().loss, matchScene().radio.loss);
  EXPECT_EQ(tree_->set("robots/red1", "1 2 3 4").error().text(),
            "robots/red1: expected 2 to 3 numbers, found 4");
}

TEST_F(MatchTree, AllObjectsAreListedAndHaveValues) {
  const auto all = tree_->list("");
  EXPECT_GT(all.size(), 400u);
  for (const SceneTree::Object& object : all) EXPECT_NE(get(object.path), "") << object.path;
  const auto robot = tree_->list("robots/red1");
  EXPECT_EQ(robot.front().path, "robots/red1");
  EXPECT_TRUE(robot.front().canBeSet);
  for (const SceneTree::Object& object : robot) EXPECT_TRUE(object.path.starts_with("robots/red1"));
  EXPECT_EQ(tree_->list("robots/red").size(), 0u);
  EXPECT_EQ(tree_->list("balls/").size(), 1u);
}

/// A short one of what `make experiments` does for half an hour.
TEST(Chaos, BreaksNothing) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic}) {
    auto scene = crowdedScene(22, 10);
    ASSERT_TRUE(scene) << scene.error().text();
    scene->fidelity = fidelity;
    auto simulation = Simulation::make(*scene, 7);
    ASSERT_TRUE(simulation) << simulation.error().text();
    Chaos chaos{**simulation, 7};
    const int ticks = fidelity == Fidelity::kinematic ? 3000 : 500;
    for (int i = 0; i < ticks; ++i) {
      (*simulation)->takeImages(i % 500 < 5);
      chaos.step();
      ASSERT_EQ(chaos.wrong(), "") << i;
    }
    EXPECT_EQ((*simulation)->failure(6).empty(), fidelity == Fidelity::dynamic);  // not yet
    EXPECT_EQ((*simulation)->failure(5), "");
  }
}

class Thrower : public RobotController {
 public:
  void cycle(const RobotInput& input, RobotOutput&) override {
    if (input.now > Time{80}) throw std::runtime_error("out of battery");
    ++cycles;
  }
  int cycles = 0;
};

TEST_F(MatchTree, AControllerThatThrowsStopsItsRobotOnly) {
  auto owned = std::make_unique<Thrower>();
  Thrower* thrower = owned.get();
  simulation_->attach(2, std::move(owned));
  for (int i = 0; i < 50; ++i) simulation_->step();
  EXPECT_EQ(thrower->cycles, 10);
  EXPECT_EQ(simulation_->input(2).image, nullptr) << "no stale image";
  EXPECT_EQ(simulation_->failure(2), "its program failed: exception: out of battery");
  EXPECT_EQ(simulation_->failure(3), "");
  EXPECT_EQ(simulation_->time(), Time{400});
}

}  // namespace
}  // namespace gt
