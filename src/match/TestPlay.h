#pragma once
#include <gtest/gtest.h>

#include <optional>

#include "match/PlayFigures.h"
#include "match/PlayMoment.h"

namespace gt {

/// A red and a blue robot and a ball that lies before the red one, for tests of the classes that
/// measure how teams play.
struct TestPlay {
  TestPlay() {
    moment.time = Time{1000};
    moment.robots.resize(2);
    moment.robots[0].team = TeamColor::red;
    moment.robots[0].position = {850, 0};
    moment.robots[1].team = TeamColor::blue;
    moment.robots[1].position = {1900, 0};
    moment.ball.position = {1000, 0};
  }
  /// Passes the moment to a watch, and advances its time by `ms`.
  template <typename Watch>
  void see(Watch& watch, int ms = 8) {
    watch.see(moment);
    moment.time = moment.time + ms;
  }
  /// The red robot kicks the ball, which leaves with a speed.
  template <typename Watch>
  void kick(Watch& watch, const Vector2d& speed) {
    moment.robots[0].kicks = true;
    see(watch);
    touch(0);
    moment.ball.speed = speed;
    see(watch, 300);
    moment.robots[0].kicks = false;
    see(watch);
  }
  void touch(int robot) {
    moment.ball.lastToucher = robot;
    moment.ball.lastTouched = moment.time;
  }

  PlayMoment moment;
};

/// The deceleration of the ball in these tests (mm/s^2).
constexpr double testDeceleration = 250;

/// The value of a figure; empty if there is none of that name.
inline std::optional<double> figureOf(const std::vector<PlayFigure>& figures,
                                      const std::string& name) {
  for (const PlayFigure& figure : figures)
    if (figure.name == name) return figure.value;
  return std::nullopt;
}

}  // namespace gt
