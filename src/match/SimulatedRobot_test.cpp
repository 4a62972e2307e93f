#include "match/SimulatedRobot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <iostream>

#include "base/Statistics.h"
#include "match/TestMatch.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/LandmarksPercept.h"
#include "robot/Robot.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// The pixels that the processes of a robot hold, one entry for each process that reads images.
std::vector<const Pixel*> imagesOf(const SimulatedRobot& robot) {
  std::vector<const Pixel*> pixels;
  for (const auto& process : robot.robot().processes())
    if (process->blackboard().find("Image"))
      pixels.push_back(process->blackboard().get<Image>().pixels.data());
  return pixels;
}

bool sameBytes(const Image& a, const Image& b) {
  return a.pixels.size() == b.pixels.size() &&
         std::memcmp(a.pixels.data(), b.pixels.data(), sizeof(Pixel) * a.pixels.size()) == 0;
}

/// docs/image-path.md: what the camera writes is what the first process that reads images works on.
/// Each further one gets a copy, as it may run on another machine.
TEST(SimulatedRobot, ImagesAreNotCopiedOnTheirWayToTheImageProcessor) {
  for (const char* layout : {"cmd", "single", "pmbm"}) {
    MatchOptions options;
    options.scene = "scenes/one-robot.scene";
    options.layout = "layouts/" + std::string{layout} + ".layout";
    const auto match = Match::make(options);
    ASSERT_TRUE(match) << match.error().text();
    SimulatedRobot& robot = *(*match)->robots().front();
    int images = 0;
    for (int tick = 0; tick < 50; ++tick) {
      const Image* place = robot.nextImage();
      ASSERT_NE(place, nullptr) << layout;
      // Two buffers take turns once both have their size.
      const Pixel* written = place->pixels.data();
      (*match)->step();
      if (!(*match)->simulation().input(0).image || ++images <= 2) continue;
      const auto held = imagesOf(robot);
      EXPECT_EQ(held.front(), written) << layout << " at " << tick;
      EXPECT_EQ(std::ranges::count(held, written), 1) << layout;
      EXPECT_EQ(held.size(), 1u) << "no process but one reads images, so there is no copy at all";
      EXPECT_EQ((*match)->simulation().image(0).time, (*match)->time());
    }
    EXPECT_EQ(images, 10) << layout;
  }
}

/// What nobody asked for is not kept: drawings that a console switches on do not pile up.
TEST(SimulatedRobot, ReportImagesHaveTheirOwnDrawingsOnly) {
  MatchOptions options;
  options.scene = "scenes/one-robot.scene";
  options.minutes = 0.1;
  options.images = 3;  // one each 2 s; the third is due when the match ends
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  Robot& robot = (*match)->robots().front()->robot();
  for (const char* key : {"ImageProcessor/percepts", "ImageProcessor/horizon"})
    ASSERT_TRUE(robot.request(DebugRequest{key, DebugKeyMode::always, 0}));
  while (!(*match)->finished()) (*match)->step();
  ASSERT_EQ((*match)->images().size(), 2u);
  for (const ReportImage& kept : (*match)->images()) {
    EXPECT_LE(kept.drawings.size(), 2u) << kept.title;
    EXPECT_EQ(kept.image.pixels.size(), kept.image.area());
  }
}

TEST(SimulatedRobot, ACameraThatIsOffRepeatsTheLastImage) {
  MatchOptions options;
  options.scene = "scenes/one-robot.scene";
  const auto match = Match::make(options);
  ASSERT_TRUE(match) << match.error().text();
  Simulation& simulation = (*match)->simulation();
  for (int i = 0; i < 23; ++i) (*match)->step();
  const Image last = simulation.image(0);
  simulation.takeImages(0, false);
  for (int i = 0; i < 20; ++i) {
    (*match)->step();
    EXPECT_TRUE(sameBytes(simulation.image(0), last));
  }
  EXPECT_GT(simulation.image(0).time, last.time);
  simulation.takeImages(0, true);
  for (int i = 0; i < 10; ++i) (*match)->step();
  EXPECT_FALSE(sameBytes(simulation.image(0), last));
}

/// A robot that stands and looks, whose body leans otherwise than its joints measure (degrees).
struct Lean {
  double tilt = 0, roll = 0;
};

/// How far from the truth percepts lie.
struct Distances {
  RunningStatistics ball, flags;  ///< mm
};

class LeaningBody : public MatchTest {
 protected:
  /// Ball 1 m away and the flag behind it as a robot measures them, with robot.cfg or without.
  void measure(const Lean& lean, bool corrected, std::uint64_t seed, Distances& distances) {
    const fs::path config = folder / "config";
    fs::copy("config", config, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    const Lean known = corrected ? lean : Lean{};
    ASSERT_TRUE(writeFile((config / "robot.cfg").string(),
                          "[00022D1F626B]\nbodyTiltOffset " +
                              std::to_string(fromDegrees(known.tilt)) + "\nbodyRollOffset " +
                              std::to_string(fromDegrees(known.roll)) + "\n"));
    // It shall not find out by itself.
    ASSERT_TRUE(writeFile((config / "modules/SensorDataProcessor.Default.cfg").string(),
                          "lean.learns false\n"));
    const auto here = [](const char* path) { return fs::absolute(path).string(); };
    ASSERT_TRUE(writeFile(
        (folder / "lean.scene").string(),
        "<scene field=\"" + here("models/field2003.xml") + "\" config=\"" + config.string() +
            "\"><game referee=\"false\"/><robots><robot x=\"1000\" y=\"700\" rotation=\"32\" "
            "model=\"" +
            here("models/ers210.xml") + "\" layout=\"" + here("layouts/cmd.layout") +
            "\" address=\"00022D1F626B\" bodyTilt=\"" + std::to_string(lean.tilt) +
            "\" bodyRoll=\"" + std::to_string(lean.roll) +
            "\"/></robots><balls><ball x=\"1848\" y=\"1230\" model=\"" + here("models/ball.xml") +
            "\"/></balls></scene>"));
    const auto match = make("logs", seed, 1, 1, (folder / "lean.scene").string());
    Robot& robot = match->robots()[0]->robot();
    ASSERT_TRUE(robot.request(SolutionRequest{"BehaviorControl", "disabled"}));
    for (int tick = 0; tick < 400; ++tick) {
      robot.layIfDisabled(HeadControlMode{HeadMode::lookAtPoint, {1000, 0, 150}});
      match->step();
      if (tick >= 250) add(*match, distances);
    }
  }

  /// What the last image showed against the truth.
  void add(Match& match, Distances& distances) {
    const Robot& robot = match.robots()[0]->robot();
    const World& world = match.simulation().world();
    const Pose2D pose = world.robot(0).pose;
    const auto& ball = *robot.provided<BallPercept>();
    if (ball.seen)
      distances.ball.add((ball.offset - relative(pose, world.ball(0).position)).norm());
    const auto& landmarks = *robot.provided<LandmarksPercept>();
    const FieldDimensions field;
    for (int i = 0; i < landmarks.numberOfFlags; ++i) {
      const FlagPercept& flag = landmarks.flags[static_cast<std::size_t>(i)];
      if (flag.type != FlagType::skyblueAbovePink || flag.distance == 0) continue;
      const Vector2d place = flag.distance * direction(flag.angle);
      const double elevation = (flag.boundary.top + flag.boundary.bottom) / 2;
      const double height = landmarks.cameraOffset.z() +
                            (place - landmarks.cameraOffset.head<2>()).norm() * std::tan(elevation);
      const Vector2d truth = relative(pose, positionOf(flag.type, TeamColor::red, field));
      const Vector2d off = place - truth;
      distances.flags.add(
          std::hypot(off.x(), off.y(), height - (field.flagBottom + field.flagTop) / 2));
    }
  }
};

/// Report B.4.5: with the corrections in robot.cfg, what leans otherwise than its joints measure
/// sees things where they are.
TEST_F(LeaningBody, RobotCfgBringsPerceptsBackToTheTruth) {
  Distances upright, leaning, corrected;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    measure({}, false, seed, upright);
    for (const Lean lean : {Lean{3, 0}, Lean{-3, 0}, Lean{0, 4}, Lean{2, -4}}) {
      measure(lean, false, seed, leaning);
      measure(lean, true, seed, corrected);
    }
  }
  for (const auto& [name, d] : {std::pair{"upright", &upright}, std::pair{"leaning", &leaning},
                                std::pair{"corrected", &corrected}})
    std::cout << name << ": ball " << d->ball.mean() << " mm of " << d->ball.count() << ", flag "
              << d->flags.mean() << " mm of " << d->flags.count() << " off\n";
  ASSERT_GT(upright.ball.count(), 300u);
  ASSERT_GT(upright.flags.count(), 300u);
  EXPECT_GT(leaning.ball.mean(), 2 * upright.ball.mean());
  EXPECT_GT(leaning.flags.mean(), 1.5 * upright.flags.mean());
  EXPECT_LT(corrected.ball.mean(), 1.3 * upright.ball.mean() + 3);
  EXPECT_LT(corrected.flags.mean(), 1.3 * upright.flags.mean() + 3);
}

}  // namespace
}  // namespace gt
