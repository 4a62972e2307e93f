#include "match/report/SampleMatch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/Random.h"
#include "match/report/Report.h"

namespace gt {
namespace {

constexpr int lengthOfMatch = 600;
constexpr std::array goalTimes{73, 188, 251, 402, 547};
constexpr std::array scorers{TeamColor::red, TeamColor::blue, TeamColor::red, TeamColor::red,
                             TeamColor::blue};

void addEvent(MatchSummary& match, int second, std::string kind, std::string text, TeamColor team) {
  MatchEvent event;
  event.time = {second * 1000};
  event.kind = std::move(kind);
  event.text = std::move(text);
  event.team = team;
  event.redScore = match.redScore;
  event.blueScore = match.blueScore;
  match.events.push_back(event);
}

void addGoal(MatchSummary& match, std::size_t goal) {
  const TeamColor side = scorers[goal];
  const bool own = goal == 2;
  ++(side == TeamColor::red ? match.redScore : match.blueScore);
  addEvent(match, goalTimes[goal], "goal",
           "Goal for " + std::string(enumName(side)) + (own ? " (own goal of blue 2)" : ", by 3"),
           side);
  match.events.back().ownGoal = own;
  match.events.back().player = own ? 2 : 3;
  addEvent(match, goalTimes[goal] + 12, "kickOff", "Kick-off", opponent(side));
}

void addEvents(MatchSummary& match) {
  addEvent(match, 0, "kickOff", "Kick-off for red", TeamColor::red);
  std::size_t goal = 0;
  for (const int second : {40, 131, 219, 300, 330, 470, 505}) {
    while (goal < goalTimes.size() && goalTimes[goal] < second) addGoal(match, goal++);
    if (second == 300)
      addEvent(match, second, "halfTime", "Half time", TeamColor::red);
    else
      addEvent(match, second, "stuckBall", "The ball was stuck & is put <back>", TeamColor::blue);
  }
  while (goal < goalTimes.size()) addGoal(match, goal++);
  addEvent(match, lengthOfMatch, "gameOver", "The match is over", TeamColor::red);
}

/// Positions of a ball that wanders, and is in the goal when a goal is scored.
std::vector<Vector2d> ballPath(Random& random) {
  std::vector<Vector2d> path;
  Vector2d ball = Vector2d::Zero(), speed = Vector2d::Zero();
  std::size_t goal = 0;
  for (int t = 0; t < lengthOfMatch; ++t) {
    path.push_back(ball);
    speed = speed * 0.8 + Vector2d{random.gaussian(), random.gaussian()} * 120;
    ball += speed;
    ball.x() = std::clamp(ball.x(), -2000.0, 2000.0);
    ball.y() = std::clamp(ball.y(), -1250.0, 1250.0);
    if (goal == goalTimes.size()) continue;
    const Vector2d mouth{scorers[goal] == TeamColor::red ? 2250 : -2250, 0};
    const int left = goalTimes[goal] - t;
    if (left <= 5) ball += (mouth - ball) / std::max(1, left - 1);
    if (left == 0) {
      ball = speed = Vector2d::Zero();
      ++goal;
    }
  }
  return path;
}

/// Adds some figures of play, and a shot for each goal.
void addPlay(MatchSummary& match) {
  double share = 36;
  for (const char* use :
       {"comes", "rolls", "linedUp", "kicked", "pushed", "duel", "goalie", "searched", "left"}) {
    match.play.push_back({std::string{"ball."} + use, "%", share});
    share *= 0.65;
  }
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    const auto add = [&](const char* name, const char* unit, double value) {
      match.play.push_back({std::string{enumName(team)} + '.' + name, unit,
                            team == TeamColor::red ? value : 0.8 * value});
    };
    add("possession", "%", 53);
    add("kicks", "1/min", 4.5);
    add("kick.afterTouch.median", "s", 5.6);
    add("kick.way.median", "mm", 702);
    add("penalties", "in 5 min", 1.5);
    add("penalties.illegalDefender", "in 5 min", 1.5);
    add("penalties.ballHolding", "in 5 min", 0);
  }
  for (std::size_t i = 0; i < goalTimes.size(); ++i) {
    ShotSummary shot;
    shot.time = {(goalTimes[i] - 1) * 1000};
    shot.team = scorers[i];
    shot.robot = scorers[i] == TeamColor::red ? 2 : 6;
    shot.origin = {scorers[i] == TeamColor::red ? 1200. : -1200., 300};
    shot.speed = 1100;
    shot.goalieMoved = 40;
    shot.goalieAction = i % 2 == 0 ? "blockLeft" : "";
    shot.end = ShotEnd::goal;
    match.shots.push_back(shot);
  }
}

ErrorStatistics statistics(double median) {
  return {14500, 1.2 * median, median, 3.1 * median, 7 * median};
}

RobotSummary sampleRobot(int index, const std::vector<Vector2d>& ball, Random& random) {
  RobotSummary robot;
  robot.team = index < 4 ? TeamColor::red : TeamColor::blue;
  robot.player = index % 4 + 1;
  robot.role = static_cast<PlayerRole>(index % 4);
  robot.name = std::string(enumName(robot.team)) + std::to_string(robot.player);
  robot.log = robot.name + ".mcap";
  const double side = index < 4 ? -1 : 1, eagerness = 0.25 * robot.player - 0.2;
  Vector2d at{side * (2100 - 450 * robot.player), 300.0 * (robot.player % 2 == 0 ? 1 : -1)};
  const Vector2d home = at;
  double heading = index < 4 ? 0 : pi, error = 120;
  for (const Vector2d& target : ball) {
    const Vector2d wanted = home + (target - home) * eagerness - at;
    const Vector2d step = wanted.normalized() * std::min(wanted.norm(), random.uniform(40, 230));
    heading = normalize(heading + normalize(angleOf(target - at) - heading) * 0.4);
    at += step;
    error = std::clamp(error * std::exp(0.25 * random.gaussian() + 0.1 * std::log(95 / error)), 10.,
                       2500.);
    robot.distanceWalked += step.norm();
    robot.samples.push_back({Pose2D{heading, at}, error});
  }
  robot.localizationError = statistics(80 + 12 * index);
  robot.rotationError = statistics(0.04 + 0.005 * index);
  robot.ballError = statistics(60 + 9 * index);
  robot.falls = index == 5 ? 1 : 0;
  robot.goals = robot.player == 3 ? 2 : 0;
  robot.ownGoals = index == 5 ? 1 : 0;
  robot.kicks = {{"headKick", 4 * index}, {"forwardKickHard", 11 + index}};
  return robot;
}

}  // namespace

MatchSummary sampleMatch(std::uint64_t seed) {
  Random random{seed};
  MatchSummary match;
  match.scene = "scenes/match.scene";
  match.seed = seed;
  match.duration = {lengthOfMatch * 1000};
  addEvents(match);
  match.ball = ballPath(random);
  addPlay(match);
  for (int i = 0; i < 8; ++i) match.robots.push_back(sampleRobot(i, match.ball, random));
  return match;
}

MatchTimes sampleTimes() {
  MatchTimes times{14.2, 42.3, 2, {}};
  double totalMs = 9100;
  for (const char* part :
       {"camera", "ImageProcessor", "SelfLocator", "physics", "sensors", "BehaviorControl",
        "WalkingEngine", "BallLocator", "MotionControl", "SensorDataProcessor", "HeadControl",
        "radio", "logs", "referee", "TeamBallLocator", "RobotStateDetector", "SpecialActions",
        "LEDControl", "oracle"}) {
    times.parts.push_back({part, totalMs > 1000 ? 120'000 : 600'000, totalMs});
    totalMs *= 0.72;
  }
  return times;
}

Image sampleImage(std::uint64_t seed, const Vector2d& ball, double radius) {
  Random random{seed};
  Image image;
  image.allocate();
  for (int y = 0; y < image.info.height; ++y)
    for (int x = 0; x < image.info.width; ++x) {
      const double noise = 6 * random.gaussian();
      const auto level = [&](double value) {
        return static_cast<std::uint8_t>(std::clamp(value + noise, 0.0, 255.0));
      };
      const bool isBall = (Vector2d(x + 0.5, y + 0.5) - ball).norm() < radius;
      Pixel& pixel = image.at(x, y);
      pixel = isBall   ? Pixel{level(150), 70, 190}
              : y < 40 ? Pixel{level(110), 128, 128}
              : y < 60 ? Pixel{level(215), 126, 130}
                       : Pixel{level(85), 105, 100};
    }
  return image;
}

std::vector<ReportPicture> samplePictures(std::uint64_t seed, int count) {
  Random random{seed};
  std::vector<ReportPicture> pictures;
  for (int i = 0; i < count; ++i) {
    const Vector2d ball{random.uniform(20, 156), random.uniform(65, 130)};
    const double radius = random.uniform(5, 18);
    Drawing drawing{"ImageProcessor/percepts", DrawingSpace::image, {}};
    drawing.elements = {
        {ElementType::circle, {ball}, radius, colors::red, 2, ""},
        {ElementType::line, {{0, 45}, {176, 38}}, 0, colors::white, 1, ""},
        {ElementType::arrow, {{88, 140}, ball}, 0, colors::yellow, 2, ""},
        {ElementType::polygon, {{20, 10}, {34, 10}, {34, 52}, {20, 52}}, 0, colors::pink, 2, ""},
        {ElementType::text, {{38, 20}}, 9, colors::white, 1, "flag"},
        {ElementType::point, {{88, 140}}, 2, colors::orange, 1, ""}};
    const int second = 30 + 47 * i;
    pictures.push_back(reportPicture(
        "blue " + std::to_string(i % 4 + 1) + ", " + std::to_string(second / 60) + ":" +
            std::to_string(second % 60 + 100).substr(1),
        sampleImage(seed + static_cast<std::uint64_t>(i), ball, radius), std::array{drawing}));
  }
  return pictures;
}

}  // namespace gt
