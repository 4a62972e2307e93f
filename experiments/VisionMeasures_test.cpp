#include "VisionMeasures.h"

#include <gmock/gmock.h>

#include "base/DataRoot.h"
#include "simulation/scene/Scene.h"

namespace gt {
namespace {

/// The first robot of the match scene looks ahead in an otherwise empty field; percepts are made
/// up.
class VisionMeasuresTest : public testing::Test {
 protected:
  VisionMeasuresTest() {
    for (std::size_t i = 1; i < world_->robotCount(); ++i)
      world_->placeRobot(i, {0, -1900, 250 * static_cast<double>(i) - 1000});
    world_->placeBall(0, {-2000, 1200});
  }

  /// Takes an image from a pose.
  void look(const Pose2D& from, double headTilt = 0) {
    world_->placeRobot(0, from);
    std::vector<RobotCommand> commands(world_->activeRobots());
    for (RobotCommand& command : commands) command.joints[Joint::headTilt] = headTilt;
    constexpr int untilHeadsRest = 60;  // ticks
    for (int i = 0; i < untilHeadsRest; ++i) world_->step(commands);
    const CameraView camera = cameraView(*world_, 0, scene_.optics);
    renderer_.render(world_->data(), camera, CameraEffects::none(), 1, view_.image, &view_.truth);
    view_.camera = trueMatrix(camera, world_->robot(0).pose);
    truth_.look(view_);
  }
  Tally compared() {
    Tally tally;
    measures_.comparePercepts(percepts_, view_.camera, tally);
    percepts_ = {};
    return tally;
  }
  double bearing(const Vector2d& place) const {
    return angleOf(place - view_.camera.pose.translation.head<2>());
  }
  /// The percept of a goal that is seen as a whole, turned by an angle.
  GoalPercept goal(GoalColor color, double turned = 0) const {
    GoalPercept percept;
    percept.color = color;
    percept.boundary.left = bearing(truth_.post(color, true)) + turned;
    percept.boundary.right = bearing(truth_.post(color, false)) + turned;
    percept.angle = (percept.boundary.left + percept.boundary.right) / 2;
    return percept;
  }
  void add(const GoalPercept& percept) {
    LandmarksPercept& landmarks = percepts_.landmarks;
    landmarks.goals[static_cast<std::size_t>(landmarks.numberOfGoals++)] = percept;
  }
  void addFlag(FlagType type, double angle) {
    LandmarksPercept& landmarks = percepts_.landmarks;
    FlagPercept& flag = landmarks.flags[static_cast<std::size_t>(landmarks.numberOfFlags++)];
    flag.type = type;
    flag.angle = angle;
  }
  void seeBall(double turned, double distanceFactor) {
    const Vector2d place = truth_.ball();
    const Vector3d ray = Vector3d{place.x(), place.y(), FieldDimensions{}.ballRadius} -
                         view_.camera.pose.translation;
    percepts_.ball.seen = true;
    percepts_.ball.angle = {std::atan2(ray.y(), ray.x()) + turned,
                            std::atan2(ray.z(), ray.head<2>().norm())};
    percepts_.ball.offset = distanceFactor * rotated(place, turned);
  }
  std::vector<Vector2d>& opponents() { return percepts_.players.players[TeamColor::blue]; }

  SceneDescription scene_ = *loadScene(DataRoot{}.path("scenes/match.scene"));
  std::unique_ptr<World> world_ = *makeWorld(scene_, Random{1});
  CameraScene cameraScene_{world_->model()};
  CameraRenderer renderer_{cameraScene_};
  GameView view_;
  VisionTruth truth_{*world_, scene_};
  VisionMeasures measures_{truth_};
  FoundPercepts percepts_;
};

double percent(const Tally& tally, const std::string& name) {
  const auto rate = tally.rates.find(name);
  return rate == tally.rates.end() ? -1 : rate->second.percent();
}

TEST_F(VisionMeasuresTest, AGoalIsFoundOnlyWhereItIs) {
  look({0, 1000, 0});
  for (const double turned : {0., 3., 5.}) {
    add(goal(GoalColor::skyblue, fromDegrees(turned)));
    const Tally tally = compared();
    EXPECT_EQ(percent(tally, "goals.found"), turned < 4 ? 100 : 0) << turned;
    EXPECT_EQ(percent(tally, "goals.false"), turned < 4 ? 0 : 100) << turned;
  }
  add(goal(GoalColor::yellow));
  EXPECT_EQ(percent(compared(), "goals.false"), 100);
}

TEST_F(VisionMeasuresTest, EachPartOfAGoalsPerceptMustBeAtTheGoal) {
  look({0, 1000, 0});
  constexpr double wide = fromDegrees(8);
  const auto isFalse = [&](const auto& change) {
    GoalPercept percept = goal(GoalColor::skyblue);
    change(percept);
    add(percept);
    return percent(compared(), "goals.false") == 100;
  };
  EXPECT_TRUE(isFalse([&](GoalPercept& p) { p.boundary.left += wide; }));
  EXPECT_TRUE(isFalse([&](GoalPercept& p) { p.boundary.left -= wide; }));
  EXPECT_TRUE(isFalse([&](GoalPercept& p) { p.boundary.right -= wide; }));
  EXPECT_TRUE(isFalse([&](GoalPercept& p) { p.angle += 3 * wide; }));
  const auto cutOff = [](double by) {
    return [by](GoalPercept& p) {
      p.boundary.leftOnBorder = true;
      p.boundary.left -= by;
    };
  };
  EXPECT_FALSE(isFalse(cutOff(wide)));
  EXPECT_TRUE(isFalse(cutOff(-wide)));
}

TEST_F(VisionMeasuresTest, OnePerceptIsRightForAGoal) {
  look({0, 1000, 0});
  add(goal(GoalColor::skyblue));
  add(goal(GoalColor::skyblue));
  const Tally tally = compared();
  EXPECT_EQ(percent(tally, "goals.found"), 100);
  EXPECT_EQ(percent(tally, "goals.false"), 50);
}

TEST_F(VisionMeasuresTest, AFlagIsFoundOnlyWhereItIs) {
  constexpr FlagType type = FlagType::skyblueAbovePink;
  const Vector2d flag = positionOf(type, TeamColor::red, {});
  look({angleOf(flag), 0, 0});
  const double angle = angleOf(truth_.flag(type));
  for (const double turned : {0., 3., 5.}) {
    addFlag(type, angle + fromDegrees(turned));
    const Tally tally = compared();
    EXPECT_EQ(percent(tally, "flags.found"), turned < 4 ? 100 : 0) << turned;
    EXPECT_EQ(percent(tally, "flags.false"), turned < 4 ? 0 : 100) << turned;
  }
  addFlag(FlagType::yellowAbovePink, angle);
  EXPECT_EQ(percent(compared(), "flags.false"), 100);
  addFlag(type, angle);
  addFlag(type, angle);
  EXPECT_EQ(percent(compared(), "flags.false"), 50);
}

TEST_F(VisionMeasuresTest, ABallIsFoundOnlyWhereItIs) {
  world_->placeBall(0, {1000, 0});
  look({0, 0, 0}, -0.2);
  struct Case {
    double turned, factor;
    bool right;
  };
  for (const auto& [turned, factor, right] :
       {Case{0, 1, true}, Case{3, 1, true}, Case{5, 1, false}, Case{0, 1.2, true},
        Case{0, 1.3, false}, Case{0, 0.7, false}}) {
    seeBall(fromDegrees(turned), factor);
    const Tally tally = compared();
    EXPECT_EQ(percent(tally, "ball.found"), right ? 100 : 0) << turned << ' ' << factor;
    EXPECT_EQ(percent(tally, "ball.false"), right ? 0 : 100) << turned << ' ' << factor;
  }
}

TEST_F(VisionMeasuresTest, BallsAtTheImagesBorderAndHiddenOnesHaveFiguresOfTheirOwn) {
  const auto look = [&](const Vector2d& ball, double tilt) {
    world_->placeBall(0, ball);
    this->look({0, 0, 0}, tilt);
    seeBall(0, 1);
    return compared();
  };
  const Tally whole = look({1000, 0}, -0.2);
  EXPECT_EQ(percent(whole, "ball.found"), 100);
  EXPECT_EQ(percent(whole, "ball.rim.found"), -1);
  EXPECT_EQ(percent(whole, "ball.partly.found"), -1);
  int rims = 0, parts = 0;
  for (double y = 400; y < 800; y += 10) {
    const Tally tally = look({1000, y}, -0.2);
    rims += percent(tally, "ball.rim.found") == 100 ? 1 : 0;
    if (percent(tally, "ball.partly.found") != 100) continue;
    ++parts;
    EXPECT_EQ(percent(tally, "ball.found"), -1) << y;
  }
  EXPECT_GT(parts, 0);
  EXPECT_GT(rims, parts);
}

TEST_F(VisionMeasuresTest, ABallThatIsNotInTheImageIsNotFoundByChance) {
  world_->placeBall(0, {-1000, 0});
  look({0, 0, 0}, -0.2);
  seeBall(0, 1);
  EXPECT_EQ(percent(compared(), "ball.false"), 100);
}

TEST_F(VisionMeasuresTest, ARobotIsFoundWithinAQuarterOfAMeter) {
  const std::size_t opponent = world_->robotCount() - 1;
  ASSERT_EQ(truth_.team(opponent), TeamColor::blue);
  world_->placeRobot(opponent, {pi / 2, 1100, 0});
  look({0, 0, 0}, -0.1);
  const Vector2d place = truth_.robot(opponent);
  for (const double behind : {0., 240., 260., -260.}) {
    opponents() = {place + Vector2d{behind, 0}};
    const Tally tally = compared();
    const bool right = std::abs(behind) < 250;
    EXPECT_EQ(percent(tally, "players.found"), right ? 100 : 0) << behind;
    EXPECT_EQ(percent(tally, "players.misplaced"), right ? 0 : 100) << behind;
    EXPECT_EQ(percent(tally, "players.nothing"), 0) << behind;
  }
  opponents() = {rotated(place, 0.5)};
  const Tally beside = compared();
  EXPECT_EQ(percent(beside, "players.misplaced"), 0);
  EXPECT_EQ(percent(beside, "players.nothing"), 100);
  percepts_.players.players[TeamColor::red] = {place};
  const Tally tally = compared();
  EXPECT_EQ(percent(tally, "players.found"), 0);
  EXPECT_EQ(percent(tally, "players.misplaced"), 0);
  EXPECT_EQ(percent(tally, "players.nothing"), 0);
  EXPECT_EQ(percent(tally, "players.color"), 0);
}

TEST_F(VisionMeasuresTest, OnePerceptServesOneRobot) {
  const std::size_t first = world_->robotCount() - 1, second = first - 1;
  ASSERT_EQ(truth_.team(second), TeamColor::blue);
  world_->placeRobot(first, {pi / 2, 900, 200});
  world_->placeRobot(second, {pi / 2, 900, -200});
  look({0, 0, 0}, -0.1);
  opponents() = {(truth_.robot(first) + truth_.robot(second)) / 2};
  EXPECT_EQ(percent(compared(), "players.found"), 50);
  opponents() = {truth_.robot(first), truth_.robot(first) + Vector2d{30, 0}};
  const Tally tally = compared();
  EXPECT_EQ(percent(tally, "players.found"), 50);
  EXPECT_EQ(percent(tally, "players.misplaced"), 50);
}

TEST_F(VisionMeasuresTest, FreeGroundMayEndNeitherTooLateNorTooEarly) {
  world_->placeBall(0, {1000, 0});
  look({0, 0, 0}, -0.2);
  const auto rates = [&](const FreeGround& line) {
    percepts_.obstacles.lines = {line};
    const Tally tally = compared();
    return std::pair{percent(tally, "freeGround.notOverestimated"),
                     percent(tally, "freeGround.notUnderestimated")};
  };
  EXPECT_EQ(rates({{450, 0}, {700, 0}, false}), (std::pair{100., 0.}));
  EXPECT_EQ(rates({{450, 0}, {950, 0}, false}), (std::pair{100., 100.}));
  EXPECT_EQ(rates({{450, 0}, {1300, 0}, false}), (std::pair{0., 100.}));
  EXPECT_EQ(rates({{450, 0}, {450, 0}, false}), (std::pair{100., 0.}));
}

// At 2.5 m a pixel is 20 cm of the ground.
TEST_F(VisionMeasuresTest, FreeGroundMayBeWrongByAPixelAndAHalf) {
  look({0, -1000, -1000}, -0.1);
  const CameraMatrix& camera = truth_.camera();
  const double x0 = camera.pose.translation.x();
  // A place at the distance d is this over d pixels below the horizon.
  const double below = camera.pose.translation.z() * camera.info.focalY;
  double wall = 1000;
  while (truth_.at({wall, 0}) == VisionTruth::Kind::ground ||
         truth_.at({wall, 0}) == VisionTruth::Kind::line)
    wall += 20;
  ASSERT_GT(wall, 2500);
  for (const double pixels : {1., -1., 2.2, -2.2}) {
    const double far = x0 + 1 / (1 / (wall - x0) + pixels / below);
    percepts_.obstacles.lines = {{{450, 0}, {far, 0}, false}};
    const Tally tally = compared();
    EXPECT_EQ(percent(tally, "freeGround.notOverestimated"), pixels > -2 ? 100 : 0) << pixels;
    EXPECT_EQ(percent(tally, "freeGround.notUnderestimated"), pixels < 2 ? 100 : 0) << pixels;
  }
}

TEST_F(VisionMeasuresTest, FreeGroundIsNotUnderestimatedWhereTheImageEnds) {
  look({0, 0, 0}, -0.8);
  double last = 250;
  while (truth_.at({last + 20, 0})) last += 20;
  percepts_.obstacles.lines = {{{250, 0}, {last - 100, 0}, true}};
  EXPECT_EQ(percent(compared(), "freeGround.notUnderestimated"), 100);
  percepts_.obstacles.lines = {{{250, 0}, {last - 200, 0}, false}};
  EXPECT_EQ(percent(compared(), "freeGround.notUnderestimated"), 0);
}

}  // namespace
}  // namespace gt
