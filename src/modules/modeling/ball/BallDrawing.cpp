#include "modules/modeling/ball/BallDrawing.h"

namespace gt {
namespace {

const DebugKey drawBall{"BallLocator/ball"};
const DebugKey drawTeamBall{"TeamBallLocator/ball"};
constexpr double radius = 43;  // mm

}  // namespace

void draw(const BallModel& ball, Debug& debug) {
  if (auto canvas = debug.onRobot(drawBall)) {
    canvas.circle(ball.position, radius, colors::orange);
    canvas.arrow(ball.position, ball.position + ball.speed, colors::orange);
  }
}

void draw(const TeamBallModel& ball, Debug& debug) {
  if (auto canvas = debug.onField(drawTeamBall)) {
    canvas.circle(ball.position, radius, colors::orange);
    if (ball.standardDeviation > 0)
      canvas.circle(ball.position, ball.standardDeviation, colors::orange);
  }
}

}  // namespace gt
