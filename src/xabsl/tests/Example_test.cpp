#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "xabsl/engine/Engine.h"
#include "xabsl/engine/Symbols.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/tests/TestBehavior.h"

/// How a robot uses XABSL, from its own variables and functions to a running engine. The behavior
/// stands in the folder `example`.
namespace {

enum class HeadMode { searchForBall, lookAtBall };

class Robot {
 public:
  Robot() {
    symbols_.enumeration<HeadMode>("head_mode", {"search_for_ball", "look_at_ball"});
    symbols_.input("ball.distance", &distance);
    symbols_.input("ball.angle", &angle);
    symbols_.input("ball.time_since_seen", xabsl::member(this, &Robot::timeSinceBallSeen));
    symbols_.input("abs", {"value"}, [](double value) { return std::abs(value); });
    symbols_.output("head.mode", [this](HeadMode mode) { headMode = mode; });
    symbols_.behavior("walk", {"x", "rotation"}, [this](double x, double rotation) {
      speed = x;
      turn = rotation;
    });
    symbols_.behavior("stand", [this] { speed = turn = 0; });
  }

  /// Loads a behavior; the one that runs stays if there is an error, which is returned.
  std::string load(const std::string& path) {
    const xabsl::Compilation compilation = xabsl::compile(path);
    if (!compilation.behavior) return xabsl::test::errors(compilation.diagnostics);
    xabsl::Engine::Creation creation = xabsl::Engine::create(*compilation.behavior, symbols_);
    if (!creation.engine) return xabsl::test::errors(creation.diagnostics);
    engine_ = std::move(creation.engine);
    return "";
  }

  std::string update(std::int64_t time) {
    now = time;
    engine_->execute(now);
    return toString(engine_->activations());
  }

  double timeSinceBallSeen() const { return static_cast<double>(now - lastSeen); }

  std::int64_t now = 0;
  std::int64_t lastSeen = -10'000;
  double distance = 3000;
  double angle = 1;
  double speed = 0;
  double turn = 0;
  HeadMode headMode = HeadMode::lookAtBall;

 private:
  xabsl::Symbols symbols_;
  std::optional<xabsl::Engine> engine_;
};

TEST(Example, PlaysFromTheSearchToTheBall) {
  Robot robot;
  ASSERT_EQ(robot.load("src/xabsl/example/agents.xabsl"), "");

  EXPECT_EQ(robot.update(0), "play() 0 ms: search 0 ms\n  walk(x = 0, rotation = 1.5)\n");
  EXPECT_EQ(robot.headMode, HeadMode::searchForBall);

  robot.lastSeen = 100;
  EXPECT_EQ(robot.update(100),
            "play() 100 ms: approach 0 ms\n"
            "  go_to_ball(speed = 100) 0 ms: turn 0 ms\n"
            "    walk(x = 50, rotation = 1)\n");
  EXPECT_EQ(robot.headMode, HeadMode::lookAtBall);

  robot.lastSeen = 1100;
  robot.angle = -0.1;
  EXPECT_EQ(robot.update(1200),
            "play() 1200 ms: approach 1100 ms\n"
            "  go_to_ball(speed = 200) 1100 ms: straight 0 ms\n"
            "    walk(x = 200, rotation = 0)\n");

  robot.distance = 100;
  EXPECT_EQ(robot.update(1300),
            "play() 1300 ms: approach 1200 ms\n"
            "  go_to_ball(speed = 200) 1200 ms: reached (target) 0 ms\n"
            "    stand()\n");
  EXPECT_EQ(robot.speed, 0);
  EXPECT_EQ(robot.update(1400), "play() 1400 ms: celebrate 0 ms\n  stand()\n");
}

TEST(Example, KeepsPlayingWhenABrokenBehaviorIsLoaded) {
  Robot robot;
  ASSERT_EQ(robot.load("src/xabsl/example/agents.xabsl"), "");
  robot.update(0);
  EXPECT_NE(robot.load("src/xabsl/example/nothing.xabsl"), "");
  EXPECT_EQ(robot.update(10), "play() 10 ms: search 10 ms\n  walk(x = 0, rotation = 1.5)\n");
}

}  // namespace
