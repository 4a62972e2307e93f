#include "simulation/Challenge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr std::int64_t pressMs = 200;
/// Contacts count separately if nothing was touched for this time between them.
constexpr std::int64_t contactMs = 1000;
/// An obstacle that moved further than this was touched; it may sink in by less.
constexpr double touchedMm = 5;
constexpr std::int64_t settlingMs = 500;
/// The tail wags if it swings by `wagging` (rad) while the robot rests.
constexpr double wagging = fromDegrees(60), restMm = 8;
constexpr std::int64_t restMs = 300;
constexpr int targetCount = 5;

/// A random place on the field, at least `margin` (mm) from the walls.
Vector2d placeOn(const FieldDimensions& field, double margin, Random& random) {
  for (;;) {
    const Vector2d place{(field.xGroundline - margin) * random.symmetric(),
                         (field.ySideline - margin) * random.symmetric()};
    // The corners are cut off by a slope of 45 degrees.
    const double corner = std::abs(place.x()) + std::abs(place.y());
    if (corner < field.xGroundline + field.ySideCorner - std::sqrt(2.) * margin) return place;
  }
}

/// A random place on the field, at least `distance` (mm) from others if one is found.
Vector2d placeAway(const FieldDimensions& field, double margin, const std::vector<Vector2d>& others,
                   double distance, Random& random) {
  constexpr int tries = 1000;
  Vector2d place = placeOn(field, margin, random);
  const auto tooNear = [&](const Vector2d& other) { return (other - place).norm() < distance; };
  for (int i = 0; i < tries && std::ranges::any_of(others, tooNear); ++i)
    place = placeOn(field, margin, random);
  return place;
}

}  // namespace

std::vector<Vector2d> randomTargets(const FieldDimensions& field, Random random) {
  constexpr double margin = 250, apart = 400;  // mm
  std::vector<Vector2d> targets;
  while (targets.size() < targetCount)
    targets.push_back(placeAway(field, margin, targets, apart, random));
  return targets;
}

Challenge::Challenge(const ChallengeParameters& parameters, const std::vector<Vector2d>& targets,
                     const Random& random)
    : parameters_{parameters}, random_{random} {
  if (parameters_.kind == ChallengeKind::localization)
    for (const Vector2d& place : targets) targets_.push_back({place});
}

int Challenge::points() const {
  int sum = 0;
  for (const Target& target : targets_) sum += target.points;
  return sum;
}

void Challenge::control(Simulation& simulation) {
  if (!prepared_) prepare(simulation);
  const Time now = simulation.time();
  const Time start = Time{} + std::llround(1000 * parameters_.start);
  simulation.sensors(0).press(Switch::back, now >= start && now - start < pressMs);
  if (finished_ || now < start) return;
  if (notes_.empty()) note(now, "start: the back switch is pressed");
  started_ = start;
  ended_ = now;
  switch (parameters_.kind) {
    case ChallengeKind::ball:
      watchBall(simulation);
      break;
    case ChallengeKind::localization:
      watchTour(simulation);
      break;
    case ChallengeKind::obstacles:
      watchCourse(simulation);
      break;
  }
}

void Challenge::finish(Time now, const std::string& text) {
  finished_ = succeeded_ = true;
  note(now, fmt::format("{} after {:.1f} s", text, seconds()));
}

void Challenge::prepare(Simulation& simulation) {
  prepared_ = true;
  World& world = simulation.world();
  if (parameters_.random && parameters_.kind == ChallengeKind::ball && world.ballCount() > 0) {
    constexpr double margin = 250, apart = 500;  // mm
    const Vector2d ball = placeOn(field_, margin, random_);
    world.placeBall(0, ball);
    world.placeRobot(0,
                     {pi * random_.symmetric(), placeAway(field_, margin, {ball}, apart, random_)});
  }
  if (parameters_.random && parameters_.kind == ChallengeKind::obstacles) prepareCourse(world);
}

// Places the obstacles as robots stand in a game: anywhere between the penalty areas, with room for
// a robot between any two.
void Challenge::prepareCourse(World& world) {
  constexpr double apart = 650, ahead = 1550, aside = 1050;  // mm
  std::vector<Vector2d> places;
  for (std::size_t i = 1; i < world.robotCount(); ++i) {
    const auto place = [&] {
      return Vector2d{ahead * random_.symmetric(), aside * random_.symmetric()};
    };
    Vector2d at = place();
    const auto tooNear = [&](const Vector2d& other) { return (other - at).norm() < apart; };
    while (std::ranges::any_of(places, tooNear)) at = place();
    places.push_back(at);
    world.placeRobot(i, {pi * random_.symmetric(), at});
  }
}

// Red defends the yellow goal, at negative x: it is the goal of a blue robot.
void Challenge::watchBall(Simulation& simulation) {
  const World& world = simulation.world();
  if (world.ballCount() == 0) return;
  const Vector2d& ball = world.ball(0).position;
  const double side = simulation.players().front().teamColor == TeamColor::blue ? -1 : 1;
  if (side * ball.x() > field_.xGroundline + world.ballRadius(0) &&
      std::abs(ball.y()) < field_.yGoal)
    finish(world.time(), "goal");
}

void Challenge::watchTour(Simulation& simulation) {
  const World& world = simulation.world();
  const RobotBody& robot = world.robot(0);
  const Time now = world.time();
  const double tail = robot.joints[Joint::tailPan];
  swung_ += std::abs(tail - tail_);
  tail_ = tail;
  if ((robot.pose.translation - restsAt_.translation).norm() > restMm || restsSince_ == never()) {
    restsAt_ = robot.pose;
    restsSince_ = now;
    swung_ = 0;
    scored_ = false;
  }
  if (scored_ || now - restsSince_ < restMs || swung_ < wagging) return;
  scored_ = true;
  Target* nearest = nullptr;
  const auto distance = [&](const Target& target) {
    return (target.place - robot.pose.translation).norm();
  };
  for (Target& target : targets_)
    if (target.distance < 0 && (!nearest || distance(target) < distance(*nearest)))
      nearest = &target;
  if (!nearest) return;
  nearest->distance = distance(*nearest);
  constexpr int precisePoints = 3, nearPoints = 1;
  nearest->points = nearest->distance <= parameters_.precise ? precisePoints
                    : nearest->distance <= parameters_.near  ? nearPoints
                                                             : 0;
  note(now, fmt::format("wags its tail {:.0f} mm from place {}: {} points", nearest->distance,
                        nearest - targets_.data() + 1, nearest->points));
  if (std::ranges::all_of(targets_, [](const Target& target) { return target.distance >= 0; }))
    finish(now, fmt::format("{} points", points()));
}

bool Challenge::touchesOther(const World& world) const {
  if (world.robot(0).pushes >= 0) return true;
  for (std::size_t i = 1; i < world.robotCount(); ++i)
    if ((world.robot(i).pose.translation - stood_[i].translation).norm() > touchedMm) return true;
  // The kinematic fidelity has no contacts of geoms.
  const auto robotOf = [&](int geom) -> std::size_t {
    for (std::size_t i = 0; i < world.robotCount(); ++i)
      if (geom >= world.parts(i).firstGeom && geom < world.parts(i).lastGeom) return i;
    return world.robotCount();
  };
  for (int n = 0; n < world.data().ncon; ++n) {
    const auto a = robotOf(world.data().contact[n].geom1),
               b = robotOf(world.data().contact[n].geom2);
    if (a != b && (a == 0 || b == 0) && std::max(a, b) < world.robotCount()) return true;
  }
  return false;
}

void Challenge::watchCourse(Simulation& simulation) {
  const World& world = simulation.world();
  const Time now = world.time();
  if (stood_.empty() || now - started_ < settlingMs) {
    stood_.resize(world.robotCount());
    for (std::size_t i = 0; i < world.robotCount(); ++i) stood_[i] = world.robot(i).pose;
    return;
  }
  if (touchesOther(world)) {
    if (touchedAt_ == never() || now - touchedAt_ > contactMs) {
      ++contacts_;
      note(now, "touches another robot");
    }
    touchedAt_ = now;
    for (std::size_t i = 0; i < world.robotCount(); ++i) stood_[i] = world.robot(i).pose;
  }
  // Its nose is in the goal.
  constexpr double nose = 200;  // mm ahead of its middle
  const double side = simulation.players().front().teamColor == TeamColor::blue ? -1 : 1;
  const Vector2d& at = world.robot(0).pose.translation;
  if (side * at.x() > field_.xGroundline - nose && std::abs(at.y()) < field_.yGoal)
    finish(now, fmt::format("is in the other goal, {} contacts,", contacts_));
}

}  // namespace gt
