#include "match/Invariants.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

#include "match/SimulatedRobot.h"
#include "representations/infrastructure/RobotFootprint.h"
#include "simulation/world/Oracle.h"
#include "streams/Type.h"

namespace gt {
namespace {

/// If an invariant has held for longer than this in between, the next violation is a new one (ms).
constexpr std::int64_t pause = 1000;
/// Depth by which bodies that touch may overlap (mm).
constexpr double deepestTouch = 20;
/// A robot whose believed position is farther from the true one is lost (mm).
constexpr double farthestOff = 1000;
/// Greatest age of a message when it is sent: the cycle of the robot that made it (ms).
constexpr double longestCycle = 100;
/// A process that has not run for longer than this is not running (ms).
constexpr std::int64_t longestIdle = 500;

/// Depth by which the footprints of two robots overlap (mm); if negative, they are that far apart.
double overlapOf(const Pose2D& a, const Pose2D& b) {
  double most = -1e9;
  for (const double here : RobotFootprint::middles)
    for (const double there : RobotFootprint::middles)
      most = std::max(most, 2 * RobotFootprint::radius -
                                (a * Vector2d{here, 0} - b * Vector2d{there, 0}).norm());
  return most;
}

std::string millimeters(double value) {
  return std::to_string(std::llround(value)) + " mm";
}

/// Half of the sides of the rectangle that the outer walls surround (mm). The outer walls are the
/// immobile boxes that are farthest from the middle.
Vector2d outerWalls(const mjModel& model, const mjData& data) {
  Vector2d walls = Vector2d::Zero();
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (model.geom_type[geom] == mjGEOM_BOX && model.geom_contype[geom] != 0 &&
        model.body_weldid[model.geom_bodyid[geom]] == 0)
      walls = walls.cwiseMax(fromMuJoCo(data.geom_xpos + 3 * geom).head<2>().cwiseAbs());
  return walls;
}

}  // namespace

Invariants::Invariants(const Simulation& simulation, const std::vector<MatchRobot*>& robots)
    : simulation_{simulation},
      robots_{robots},
      walls_{outerWalls(simulation.world().model(), simulation.world().data())},
      divergences_{simulation.world().divergences()} {}

void Invariants::update() {
  checkApart();
  checkCarpet();
  checkFinite();
  checkBelieved();
  checkRadio();
  checkPrograms();
}

void Invariants::note(Name name, const std::string& who, double amount, std::string text) {
  const std::size_t index = name.index;
  const Invariant& invariant = invariants[index];
  const Time now = simulation_.time();
  const auto open = std::find_if(breaks_.rbegin(), breaks_.rend(), [&](const Break& b) {
    return b.invariant == index && b.what.who == who && now - b.what.until <= pause &&
           (amount > 0 || b.what.text == text);  // violations without amount are noted separately
  });
  if (open == breaks_.rend()) {
    breaks_.push_back(
        {index,
         {now, now, invariant.severity, std::string{invariant.name}, who, std::move(text)},
         amount});
    return;
  }
  open->what.until = now;
  if (amount <= open->worst) return;
  open->worst = amount;
  open->what.text = std::move(text);
}

std::vector<BrokenInvariant> Invariants::broken() const {
  std::vector<BrokenInvariant> all;
  for (const Break& b : breaks_)
    if (b.what.until - b.what.time >= invariants[b.invariant].patience) all.push_back(b.what);
  return all;
}

void Invariants::checkApart() {
  const World& world = simulation_.world();
  const auto names = simulation_.scene().allRobots();
  const auto check = [&](std::size_t a, std::size_t b, double depth) {
    if (depth > deepestTouch)
      note("apart", names[a]->name + ", " + names[b]->name, depth,
           millimeters(depth) + " inside each other");
  };
  if (simulation_.scene().fidelity == Fidelity::dynamic) {
    const std::span contacts{world.data().contact, static_cast<std::size_t>(world.data().ncon)};
    for (const mjContact& contact : contacts) {
      const auto a = robotOf(contact.geom1), b = robotOf(contact.geom2);
      if (a && b && a != b) check(*a, *b, -1000 * contact.dist);
    }
    return;
  }
  for (std::size_t a = 0; a < world.robotCount(); ++a)
    for (std::size_t b = a + 1; b < world.robotCount(); ++b)
      check(a, b, overlapOf(world.robot(a).pose, world.robot(b).pose));
}

std::optional<std::size_t> Invariants::robotOf(int geom) const {
  const mjModel& model = simulation_.world().model();
  const int root = model.body_rootid[model.geom_bodyid[geom]];
  for (std::size_t i = 0; i < simulation_.world().robotCount(); ++i)
    if (simulation_.world().parts(i).body == root) return i;
  return std::nullopt;
}

void Invariants::checkCarpet() {
  const World& world = simulation_.world();
  const auto names = simulation_.scene().allRobots();
  const auto check = [&](const std::string& who, const Vector2d& place) {
    const double beyond = (place.cwiseAbs() - walls_).maxCoeff();
    if (beyond > 0) note("carpet", who, beyond, millimeters(beyond) + " outside");
  };
  for (std::size_t i = 0; i < world.robotCount(); ++i)
    check(names[i]->name, world.robot(i).pose.translation);
  for (std::size_t i = 0; i < world.ballCount(); ++i)
    check("ball" + std::to_string(i), world.ball(i).position);
}

void Invariants::checkFinite() {
  const std::int64_t divergences = simulation_.world().divergences();
  if (divergences != std::exchange(divergences_, divergences))
    note("finite", "world", 0, "the physics diverged, and was put back");
  const World& world = simulation_.world();
  const auto names = simulation_.scene().allRobots();
  const auto place = [&](const std::string& who, const Vector2d& position, double other) {
    if (!position.allFinite() || !std::isfinite(other)) note("finite", who, 0, "is nowhere");
  };
  for (std::size_t i = 0; i < world.robotCount(); ++i)
    place(names[i]->name, world.robot(i).pose.translation, world.robot(i).pose.rotation);
  for (std::size_t i = 0; i < world.ballCount(); ++i)
    place("ball" + std::to_string(i), world.ball(i).position, world.ball(i).speed.sum());
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const auto check = [&]<typename T>(const T& value) {
      if (const auto done = finite(valueOf(value)); !done)
        note("finite", simulation_.scene().robots[i].name, 0,
             std::string{typeName<T>()} + "." + done.error().text());
    };
    const auto look = [&](const auto& given) {
      if constexpr (!requires { *given; })
        check(given);
      else if (given)
        check(*given);
    };
    const RobotOutput& output = simulation_.output(i);
    const Belief& belief = robots_[i]->belief();
    std::apply([&](auto... commands) { (look(output.*commands), ...); }, RobotOutput::commands());
    std::apply([&](auto... parts) { (look(belief.*parts), ...); }, Belief::parts());
  }
}

/// Skips robots that lie, are off, or are penalized, since these cannot know where they are.
void Invariants::checkBelieved() {
  if (simulation_.referee().state() != GameState::playing) return;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotPose* pose = robots_[i]->belief().pose;
    const RobotBody& body = simulation_.world().robot(i);
    if (!pose || body.posture != Posture::standing || !robots_[i]->isOn() ||
        simulation_.input(i).game.penalty != Penalty::none)
      continue;
    const Pose2D believed = toTeam(simulation_.players()[i].teamColor, pose->pose);
    const double error = (believed.translation - body.pose.translation).norm();
    if (error > farthestOff)
      note("believed", simulation_.scene().robots[i].name, error,
           "believes to be " + millimeters(error) + " from where it is");
  }
}

void Invariants::checkRadio() {
  const RadioParameters& radio = simulation_.radio().parameters();
  const Time now = simulation_.time();
  for (std::size_t i = 0; i < robots_.size(); ++i)
    for (const TeamMessages::Received& received : simulation_.input(i).team.byPlayer) {
      if (received.timeReceived == never() || now - received.timeReceived != tickMs) continue;
      const auto delay = static_cast<double>(received.timeReceived - received.message.timeSent);
      const double outside =
          std::max(radio.delayMin - delay, delay - radio.delayMax - longestCycle);
      if (outside > 0)
        note("radio", simulation_.scene().robots[i].name, outside,
             "a message took " + std::to_string(std::llround(delay)) + " ms");
    }
}

/// Checks the robots whose processes run in this program.
void Invariants::checkPrograms() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const auto* robot = dynamic_cast<const SimulatedRobot*>(robots_[i]);
    if (!robot) continue;
    for (const auto& process : robot->robot().processes())
      if (const auto since = simulation_.time() - process->now(); since > longestIdle)
        note("running", robot->name() + "." + process->name(), static_cast<double>(since),
             "has not run for " + std::to_string(since) + " ms");
    const auto look = [&]<typename T>(std::type_identity<T>) {
      if (!robot->robot().provided<T>() || robot->robot().isDisabled(representation<T>()))
        note("solved", robot->name(), 0, "nobody provides " + std::string{typeName<T>()});
    };
    const auto all = [&](const auto&... types) { (look(types), ...); };
    std::apply(all, CommandSlots<std::type_identity>{});
    std::apply(all, BeliefSlots<std::type_identity>{});
  }
}

}  // namespace gt
