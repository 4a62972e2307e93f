#include "match/Invariants.h"

#include <gmock/gmock.h>

#include <limits>
#include <utility>

#include "framework/Requests.h"
#include "match/TestMatch.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Stands, and believes what a test says.
class Standing : public MatchRobot {
 public:
  Standing() { belief_.pose = &pose; }
  void cycle(const RobotInput&, RobotOutput& output) override {
    output.joints.angles = standing();
    output.odometry = odometry;
    if (message.timeSent != never()) output.message = std::exchange(message, {});
  }

  RobotPose pose;
  OdometryData odometry;
  TeamMessage message;  ///< Is sent once, if it bears a time.
};

/// Two robots that stand, red1 where it believes to be, and the check of their world.
class InvariantsTest : public ::testing::Test {
 protected:
  explicit InvariantsTest(Fidelity fidelity = Fidelity::kinematic) {
    SceneDescription scene = duelScene({0, -800, 0}, {500, 0});
    scene.fidelity = fidelity;
    scene.robots.resize(1);
    scene.robots.push_back(scene.robots[0]);
    scene.robots[0].name = "red1";
    scene.robots[1].name = "red2";
    scene.robots[1].role = PlayerRole::defender;
    scene.robots[1].x = 800;
    scene.game.referee = false;
    auto made = Simulation::make(scene, 1);
    EXPECT_TRUE(made) << made.error().text();
    simulation = std::move(*made);
    for (std::size_t i = 0; i < 2; ++i) {
      auto robot = std::make_unique<Standing>();
      robot->pose.pose = simulation->world().robot(i).pose;
      robots.push_back(robot.get());
      standing.push_back(robot.get());
      simulation->attach(i, std::move(robot));
    }
    invariants.emplace(*simulation, robots);
  }
  void run(double seconds) {
    for (double time = 0; time < seconds; time += tickSeconds) {
      simulation->step();
      invariants->update();
    }
  }
  std::vector<std::string> broken() const {
    std::vector<std::string> names;
    for (const BrokenInvariant& b : invariants->broken())
      names.push_back(b.invariant + ": " + b.who + ": " + b.text);
    return names;
  }

  std::unique_ptr<Simulation> simulation;
  std::vector<MatchRobot*> robots;
  std::vector<Standing*> standing;  ///< The same.
  std::optional<Invariants> invariants;
};

TEST_F(InvariantsTest, HoldForRobotsThatStand) {
  run(2);
  EXPECT_THAT(broken(), IsEmpty());
}

TEST_F(InvariantsTest, ARobotInsideAnotherOneIsFound) {
  run(0.1);
  const_cast<RobotBody&>(simulation->world().robot(1)).pose.translation =
      simulation->world().robot(0).pose.translation + Vector2d{0, 100};
  invariants->update();
  EXPECT_THAT(broken(), ElementsAre("apart: red1, red2: 56 mm inside each other"));
}

TEST_F(InvariantsTest, ABallOutsideIsFound) {
  run(0.1);
  const_cast<BallState&>(simulation->world().ball(0)).position = {0, 2400};
  invariants->update();
  EXPECT_THAT(broken(), ElementsAre("carpet: ball0: 75 mm outside"));
}

TEST_F(InvariantsTest, APenalizedRobotBesideTheFieldIsWithinTheWalls) {
  run(0.1);
  simulation->referee().penalize(simulation->world(), 0, Penalty::obstruction);
  run(0.1);
  EXPECT_THAT(broken(), IsEmpty());
}

TEST_F(InvariantsTest, APlaceThatIsNoNumberIsFound) {
  run(0.1);
  auto& robot = const_cast<RobotBody&>(simulation->world().robot(1));
  robot.pose.rotation = std::numeric_limits<double>::quiet_NaN();
  auto& ball = const_cast<BallState&>(simulation->world().ball(0));
  ball.position.x() = std::numeric_limits<double>::infinity();
  invariants->update();
  EXPECT_THAT(broken(),
              testing::IsSupersetOf({"finite: red2: is nowhere", "finite: ball0: is nowhere"}));
}

TEST_F(InvariantsTest, WhatIsNoNumberIsFound) {
  standing[0]->pose.pose.rotation = std::numeric_limits<double>::quiet_NaN();
  standing[1]->odometry.pose.translation.x() = std::numeric_limits<double>::infinity();
  standing[1]->message.timeSent = Time{tickMs};
  standing[1]->message.robotPose.translation.y() = std::numeric_limits<double>::quiet_NaN();
  run(0.1);
  EXPECT_THAT(broken(),
              ElementsAre("finite: red1: RobotPose.pose.rotation: is no number",
                          "finite: red2: OdometryData.pose.translation.x: is no number",
                          "finite: red2: TeamMessage.robotPose.translation.y: is no number"));
}

/// The same in the dynamic fidelity.
class InvariantsOfPhysics : public InvariantsTest {
 protected:
  InvariantsOfPhysics() : InvariantsTest{Fidelity::dynamic} {}
};

TEST_F(InvariantsOfPhysics, WhatDivergesIsFoundAlthoughItIsPutBack) {
  run(0.1);
  EXPECT_THAT(broken(), IsEmpty());
  const World& world = simulation->world();
  world.data().qvel[world.model().body_dofadr[world.ballBody(0)]] =
      std::numeric_limits<double>::quiet_NaN();
  run(0.1);
  EXPECT_THAT(broken(), ElementsAre("finite: world: the physics diverged, and was put back"));
}

TEST_F(InvariantsTest, ARobotThatIsLostForLongIsFoundOnce) {
  standing[0]->pose.pose.translation.y() += 1300;
  run(15);
  EXPECT_THAT(broken(), IsEmpty()) << "it may find itself again";
  standing[0]->pose.pose.translation.y() += 100;
  run(10);
  EXPECT_THAT(broken(), ElementsAre("believed: red1: believes to be 1400 mm from where it is"));
  EXPECT_EQ(invariants->broken().front().severity, Severity::warning);
  EXPECT_EQ(invariants->broken().front().time, Time{tickMs});
  EXPECT_EQ(invariants->broken().front().until, simulation->time());
}

TEST_F(InvariantsTest, AMessageThatIsTooLateIsFound) {
  RadioParameters slow;
  slow.delayMin = slow.delayMax = 400;
  slow.loss = 0;
  simulation->radio().change(slow);
  standing[0]->message.timeSent = Time{tickMs};
  run(0.1);
  slow.delayMin = slow.delayMax = 40;
  simulation->radio().change(slow);
  run(0.5);
  EXPECT_THAT(broken(), ElementsAre("radio: red2: a message took 400 ms"));
}

using InvariantsOfMatch = MatchTest;

TEST_F(InvariantsOfMatch, HoldInBothFidelities) {
  for (const char* fidelity : {"kinematic", "dynamic"}) {
    MatchOptions options;
    options.fidelity = fidelity;
    options.profile = "padova";
    options.minutes = 1;
    options.seed = 5;
    options.check = true;
    auto match = Match::make(options);
    ASSERT_TRUE(match) << match.error().text();
    ASSERT_TRUE(whistle(**match, ""));
    while (!isPlayed(**match)) (*match)->step();
    for (const BrokenInvariant& broken : (*match)->summary().broken)
      EXPECT_NE(broken.severity, Severity::error)
          << fidelity << ' ' << broken.time.ms << " ms: " << broken.invariant << ": " << broken.who
          << ": " << broken.text;
  }
}

TEST_F(InvariantsOfMatch, AProcessThatStandsAndATaskThatIsDisabledAreFound) {
  MatchOptions options;
  options.scene = "scenes/one-robot.scene";
  options.check = true;
  auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  SimulatedRobot& robot = *(*match)->robots().front();
  for (const char* task : {"SelfLocator", "BallLocator"})
    ASSERT_TRUE(robot.robot().request(SolutionRequest{task, "disabled"}));
  robot.setSlowness(1e6);
  while ((*match)->time() < Time{700}) (*match)->step();
  std::vector<std::string> names;
  for (const BrokenInvariant& b : (*match)->summary().broken)
    names.push_back(b.invariant + ": " + b.who + ": " + b.text.substr(0, b.text.find(" for")));
  EXPECT_THAT(names, testing::UnorderedElementsAre("running: red3.Cognition: has not run",
                                                   "solved: red3: nobody provides RobotPose",
                                                   "solved: red3: nobody provides BallModel"));
}

}  // namespace
}  // namespace gt
