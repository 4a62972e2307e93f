#include "simulation/Simulation.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "base/Hash.h"
#include "simulation/world/Oracle.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// Runs to the ball by the oracle, looks around, talks, and keeps a checksum of all it gets.
class Dribbler : public RobotController {
 public:
  explicit Dribbler(std::uint64_t seed) : random_(seed) {}

  void cycle(const RobotInput& input, RobotOutput& output) override {
    remember(input);
    const Vector2d ball = relative(input.oracle.robotPose, input.oracle.ballPosition);
    const bool walk = input.game.state == GameState::playing;
    const Pose2D step{std::clamp(0.02 * angleOf(ball), -0.01, 0.01), 2, 0.3 * random_.symmetric()};
    if (walk) output.odometry.pose = output.odometry.pose * step;
    output.joints.angles = standing();
    output.joints.angles[Joint::headPan] = std::sin(static_cast<double>(input.now.ms) / 300);
    if (input.image) {
      TeamMessage message;
      message.timeSent = input.now;
      message.ballPosition = input.oracle.ballPosition;
      output.message = message;
    }
  }

  std::uint64_t sum() const { return sum_.value(); }
  int pictures() const { return pictures_; }

 private:
  void add(const void* data, std::size_t size) { sum_.addBytes(data, size); }
  void remember(const RobotInput& input) {
    const SensorData& sensors = input.sensors.newest();
    add(sensors.joints.values.data(), sizeof sensors.joints.values);
    add(sensors.acceleration.data(), 3 * sizeof(double));
    add(&sensors.psd, sizeof sensors.psd);
    add(input.oracle.ballPosition.data(), 2 * sizeof(double));
    for (const auto& received : input.team.byPlayer)
      add(&received.timeReceived, sizeof received.timeReceived);
    if (!input.image) return;
    ++pictures_;
    add(input.image->pixels.data(), sizeof(Pixel) * input.image->pixels.size());
  }

  Random random_;
  Fingerprint sum_;
  int pictures_ = 0;
};

struct Outcome {
  std::vector<std::uint64_t> sums;
  std::vector<double> poses;
  bool operator==(const Outcome&) const = default;
};

SceneDescription noisyMatch() {
  SceneDescription scene = matchScene();
  scene.noise = {};
  scene.game.readyTime = 1;
  scene.game.setTime = 0.5;
  return scene;
}

std::unique_ptr<Simulation> simulation(const SceneDescription& scene, std::uint64_t seed,
                                       std::size_t threads) {
  auto made = Simulation::make(scene, seed, threads);
  EXPECT_TRUE(made) << (made ? "" : made.error().text());
  for (std::size_t i = 0; i < scene.robots.size(); ++i)
    (*made)->attach(i, std::make_unique<Dribbler>(100 * seed + i));
  return std::move(*made);
}

Outcome play(std::uint64_t seed, std::size_t threads, int ticks) {
  const auto match = simulation(noisyMatch(), seed, threads);
  for (int i = 0; i < ticks; ++i) match->step();
  Outcome outcome;
  for (std::size_t i = 0; i < 8; ++i) {
    outcome.sums.push_back(static_cast<Dribbler*>(match->controller(i))->sum());
    outcome.poses.push_back(match->world().robot(i).pose.rotation);
    outcome.poses.push_back(match->world().robot(i).pose.translation.x());
  }
  outcome.poses.push_back(match->world().ball(0).position.x());
  return outcome;
}

TEST(Simulation, SameSeedSameBitsWithAnyNumberOfThreads) {
  for (const std::uint64_t seed : {7, 8}) {
    const Outcome one = play(seed, 1, 250);
    EXPECT_EQ(one, play(seed, 1, 250));
    EXPECT_EQ(one, play(seed, 2, 250));
    EXPECT_EQ(one, play(seed, 5, 250));
    EXPECT_NE(one, play(seed + 1, 1, 250));
  }
}

/// Takes long for its images, and notes its place among those that have begun.
class Slow : public RobotController {
 public:
  Slow(std::atomic<int>& begun, std::chrono::milliseconds takes) : begun_{begun}, takes_{takes} {}

  void cycle(const RobotInput& input, RobotOutput&) override {
    if (!input.image) return;
    place = begun_++;
    std::this_thread::sleep_for(takes_);
  }
  int place = -1;

 private:
  std::atomic<int>& begun_;
  std::chrono::milliseconds takes_;
};

TEST(Simulation, RobotsWhoseImagesTookLongestBeginFirst) {
  using namespace std::chrono_literals;
  SceneDescription scene = matchScene();
  auto match = simulation(scene, 1, 2);
  std::atomic<int> begun = 0;
  std::vector<Slow*> robots;
  const std::size_t last = scene.robots.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    auto robot = std::make_unique<Slow>(begun, i == last ? 200ms : 0ms);
    robots.push_back(robot.get());
    match->attach(i, std::move(robot));
  }
  match->step();
  EXPECT_GT(robots[last]->place, 1) << "the first time nobody knows";
  begun = 0;
  for (int tick = 0; tick < 5; ++tick) match->step();
  EXPECT_EQ(begun, static_cast<int>(robots.size()));
  EXPECT_LT(robots[last]->place, 2) << "it or the other thread's first one begins";
}

TEST(Simulation, ImagesComeEveryFortyMilliseconds) {
  const auto match = simulation(noisyMatch(), 1, 2);
  for (int i = 0; i < 50; ++i) match->step();
  EXPECT_EQ(static_cast<Dribbler*>(match->controller(3))->pictures(), 10);
  EXPECT_EQ(match->image(3).time, Time{46 * tickMs});
  EXPECT_EQ(match->image(3).pixels.size(), 176u * 144u);
  match->takeImages(false);
  for (int i = 0; i < 50; ++i) match->step();
  EXPECT_EQ(static_cast<Dribbler*>(match->controller(3))->pictures(), 10);
}

TEST(Simulation, AnImageShowsTheBallWhereTheCameraLooks) {
  SceneDescription scene = duelScene({0, -800, 0}, {0, 0});
  scene.camera = CameraEffects::none();
  auto made = Simulation::make(scene, 1);
  ASSERT_TRUE(made);
  Simulation& sim = **made;
  sim.attach(0, std::make_unique<Dribbler>(1));
  sim.step();
  for (const double y : {-150., 0., 150.}) {
    sim.world().placeBall(0, {0, y});
    for (int i = 0; i < 5; ++i) sim.step();
    const Image& image = sim.image(0);
    Vector2d sum{0, 0};
    int orange = 0;
    for (int v = 0; v < image.info.height; ++v)
      for (int u = 0; u < image.info.width; ++u)
        if (image.at(u, v).cr > 180 && image.at(u, v).cb < 80) {
          sum += Vector2d{u + 0.5, v + 0.5};
          ++orange;
        }
    ASSERT_GT(orange, 20);
    const Pose3D camera = sim.world().camera(0, 2);  // without rolling shutter: the middle row's
    const Vector2d expected =
        image.info.project(camera.inverse() * Vector3d{0, y, sim.world().ballRadius(0)});
    EXPECT_LT((sum / orange - expected).norm(), 2.5) << y;
  }
}

TEST(Simulation, TheTruthOfAnImageIsKeptIfWanted) {
  SceneDescription scene = duelScene({0, -800, 0}, {0, 0});
  scene.camera = CameraEffects::none();
  auto made = Simulation::make(scene, 1);
  ASSERT_TRUE(made);
  Simulation& sim = **made;
  sim.attach(0, std::make_unique<Dribbler>(1));
  sim.step();
  EXPECT_EQ(sim.truth(0), nullptr);
  sim.keepTruth(0);
  EXPECT_EQ(sim.truth(0), nullptr);
  for (int i = 0; i < 5; ++i) sim.step();
  ASSERT_NE(sim.truth(0), nullptr);
  const Image& image = sim.image(0);
  ASSERT_EQ(sim.truth(0)->classes.size(), image.pixels.size());
  int orange = 0, looksOrange = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (sim.truth(0)->classes[i] == ColorClass::orange) {
      ++orange;
      looksOrange += image.pixels[i].cr > 180 && image.pixels[i].cb < 80;
    }
  EXPECT_GT(orange, 20);
  EXPECT_GT(looksOrange, 0.8 * orange);
}

TEST(Simulation, SensorBufferReachesBackAndTeamMatesAreHeard) {
  const auto match = simulation(noisyMatch(), 3, 1);
  for (int i = 0; i < 100; ++i) match->step();
  const SensorDataBuffer& buffer = match->input(0).sensors;
  for (std::size_t i = 1; i < buffer.frames.size(); ++i)
    EXPECT_EQ(buffer.frames[i].time - buffer.frames[i - 1].time, tickMs);
  EXPECT_EQ(buffer.newest().time, match->time());
  for (std::size_t mate = 1; mate < 4; ++mate) {
    const auto& received = match->input(0).team.byPlayer[mate];
    EXPECT_GT(received.message.timeSent, Time{300});
    EXPECT_EQ(received.message.ballPosition, match->input(0).oracle.ballPosition);
  }
  EXPECT_EQ(match->input(0).team.byPlayer[0].timeReceived, never());
}

TEST(Simulation, ARobotWithoutControllerStands) {
  auto made = Simulation::make(noisyMatch(), 3);
  ASSERT_TRUE(made);
  for (int i = 0; i < 50; ++i) (*made)->step();
  EXPECT_LT(((*made)->world().robot(0).pose.translation - Vector2d{-2000, 0}).norm(), 1);
}

TEST(Simulation, AControllerThatComesLaterHasAPast) {
  auto made = Simulation::make(noisyMatch(), 3);
  ASSERT_TRUE(made);
  for (int i = 0; i < 20; ++i) (*made)->step();
  (*made)->attach(0, std::make_unique<Dribbler>(1));
  (*made)->step();
  const SensorDataBuffer& buffer = (*made)->input(0).sensors;
  EXPECT_EQ(buffer.newest().time, (*made)->time());
  EXPECT_GT(buffer.frames.front().acceleration.z(), 8000);
}

TEST(Simulation, ExtrasAreSeenButNotControlled) {
  SceneDescription scene = noisyMatch();
  scene.extras.push_back(scene.robots.back());
  scene.extras.back().name = "extra";
  scene.extras.back().x = 500;
  scene.extras.back().y = 900;
  scene.robots.resize(2);
  const auto match = simulation(scene, 3, 1);
  for (int i = 0; i < 20; ++i) match->step();
  ASSERT_EQ(match->players().size(), 3u);
  ASSERT_EQ(match->input(0).oracle.others.size(), 2u);
  EXPECT_EQ(match->input(0).oracle.others[1].teamColor, TeamColor::blue);
}

/// Pans its head, and keeps what it gets.
class Panning : public RobotController {
 public:
  void cycle(const RobotInput& input, RobotOutput& output) override {
    output.joints.angles = standing();
    output.joints.angles[Joint::headPan] = input.now.ms >= 400 ? 0.8 : 0;
  }
};

TEST(Simulation, CommandsWaitAsLongAsTheSceneSays) {
  std::array<std::int64_t, 2> movedAt{};
  for (const double delay : {0.0, 40.0}) {
    SceneDescription scene = duelScene({}, {1500, 1000});
    scene.game.referee = false;
    scene.body.commandDelay = delay;
    auto simulation = Simulation::make(scene, 1);
    ASSERT_TRUE(simulation);
    (*simulation)->attach(0, std::make_unique<Panning>());
    auto& moved = movedAt[delay > 0];
    for (int i = 0; i < 100 && moved == 0; ++i) {
      (*simulation)->step();
      if ((*simulation)->world().robot(0).joints[Joint::headPan] > 0.001)
        moved = (*simulation)->time().ms;
    }
  }
  EXPECT_EQ(movedAt[1] - movedAt[0], 40);
}

TEST(Simulation, ImagesAreAsOldAsTheSceneSays) {
  SceneDescription scene = duelScene({}, {1500, 1000});
  scene.game.referee = false;
  auto simulation = Simulation::make(scene, 1);
  ASSERT_TRUE(simulation);
  (*simulation)->attach(0, std::make_unique<Panning>());
  for (int i = 0; i < 65; ++i) (*simulation)->step();
  const World& world = (*simulation)->world();
  const CameraInfo info;
  for (const double delay : {8.0, 16.0, 40.0}) {
    const CameraView view = cameraView(world, 0, info, delay);
    const Pose3D& then = world.camera(0, static_cast<std::size_t>(delay) / 8);
    EXPECT_NEAR((view.last.rotation - then.rotation).norm(), 0, 1e-9);
    EXPECT_NEAR((view.last.translation - then.translation).norm(), 0, 1e-9);
    EXPECT_GT((view.last.rotation - world.camera(0).rotation).norm(), 0.01) << "the head turns";
  }
  const CameraView now = cameraView(world, 0, info), late = cameraView(world, 0, info, 20);
  const auto turnOf = [](const Pose3D& a, const Pose3D& b) {
    return Eigen::AngleAxisd{a.rotation.transpose() * b.rotation}.angle();
  };
  EXPECT_NEAR(turnOf(late.last, now.last), turnOf(late.first, now.first), 0.02);
}

}  // namespace
}  // namespace gt
