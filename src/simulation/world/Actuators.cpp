#include "simulation/world/Actuators.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gt {
namespace {

constexpr double defaultTurning = 90, defaultSpeed = 500;  // deg/s, mm/s

/// Whether actuators stop at a geom: floors, walls and what stands on the field, robots, balls.
bool isSolid(const mjModel& model, int geom) {
  const int group = model.geom_group[geom];
  return model.geom_type[geom] == mjGEOM_PLANE || (group >= 2 && group <= 4);
}

bool isBelow(const mjModel& model, int body, int ancestor) {
  while (body > ancestor) body = model.body_parentid[body];
  return body == ancestor;
}

Actuators::Actuator actuatorOf(const mjModel& model, int joint) {
  Actuators::Actuator actuator;
  actuator.joint = joint;
  actuator.body = model.jnt_bodyid[joint];
  actuator.name = nameOf(model, mjOBJ_JOINT, joint);
  if (actuator.name.empty()) actuator.name = nameOf(model, mjOBJ_BODY, actuator.body);
  std::vector<double> speed = customNumbers(model, "speed/" + actuator.name);
  const auto at = [&](std::size_t i, double otherwise) {
    return i < speed.size() ? speed[i] : otherwise;
  };
  if (model.jnt_type[joint] == mjJNT_HINGE) {
    actuator.speed[0] = fromDegrees(at(0, defaultTurning));
  } else if (model.jnt_type[joint] == mjJNT_SLIDE) {
    actuator.kind = ActuatorKind::translational;
    actuator.speed[0] = at(0, defaultSpeed) / 1000;
  } else if (const auto vehicle = customNumbers(model, "vehicle/" + actuator.name);
             vehicle.size() == 3) {
    actuator.kind = ActuatorKind::vehicle;
    actuator.speed = {vehicle[0] / 1000, fromDegrees(std::clamp(vehicle[1], 0., 80.))};
    actuator.wheelBase = std::max(vehicle[2] / 1000, 0.001);
  } else {
    actuator.kind = ActuatorKind::space;
    for (std::size_t i = 0; i < 6; ++i)
      actuator.speed[i] = i < 3 ? at(i, defaultSpeed) / 1000 : fromDegrees(at(i, defaultTurning));
  }
  return actuator;
}

std::size_t coordinateCount(const World& world, const Actuators::Actuator& actuator) {
  return world.model().jnt_type[actuator.joint] == mjJNT_FREE ? 7 : 1;
}

/// Moves a free joint's pose by speeds in its own axes.
void advance(mjtNum* pose, const Vector3d& speed, const Vector3d& turning) {
  mjtNum moved[3];
  mju_rotVecQuat(moved, speed.data(), pose + 3);
  for (int k = 0; k < 3; ++k) pose[k] += moved[k] * tickSeconds;
  mju_quatIntegrate(pose + 3, turning.data(), tickSeconds);
  mju_normalize4(pose + 3);
}

}  // namespace

Actuators::Actuators(const World& world) {
  const mjModel& model = world.model();
  std::vector<bool> taken(static_cast<std::size_t>(model.nbody));
  for (std::size_t i = 0; i < world.robotCount(); ++i)
    taken[static_cast<std::size_t>(world.parts(i).body)] = true;
  for (std::size_t i = 0; i < world.ballCount(); ++i)
    taken[static_cast<std::size_t>(world.ballBody(i))] = true;
  for (int joint = 0; joint < model.njnt; ++joint) {
    if (taken[static_cast<std::size_t>(model.body_rootid[model.jnt_bodyid[joint]])] ||
        model.jnt_type[joint] == mjJNT_BALL)
      continue;
    actuators_.push_back(actuatorOf(model, joint));
    std::vector<int> geoms;
    for (int geom = 0; geom < model.ngeom; ++geom)
      if (isBelow(model, model.geom_bodyid[geom], actuators_.back().body)) geoms.push_back(geom);
    geoms_.push_back(std::move(geoms));
  }
}

Actuators::Actuator* Actuators::find(const std::string& name) {
  const auto found = std::find_if(actuators_.begin(), actuators_.end(),
                                  [&](const Actuator& actuator) { return actuator.name == name; });
  return found == actuators_.end() ? nullptr : &*found;
}

void Actuators::step(World& world) {
  for (Actuator& actuator : actuators_) {
    actuator.body = world.model().jnt_bodyid[actuator.joint];  // each fidelity has its own
    move(world, actuator);
  }
}

void Actuators::hold(World& world) const {
  for (const Actuator& actuator : actuators_)
    world.moveJoint(actuator.joint,
                    {actuator.coordinates.data(), coordinateCount(world, actuator)});
}

Actuators::Coordinates Actuators::moved(const World& world, const Actuator& actuator,
                                        double share) {
  Coordinates now{};
  const mjModel& model = world.model();
  std::copy_n(world.data().qpos + model.jnt_qposadr[actuator.joint],
              coordinateCount(world, actuator), now.begin());
  const auto speed = [&](std::size_t i) {
    return share * std::clamp(actuator.command[i], -1., 1.) * actuator.speed[i];
  };
  switch (actuator.kind) {
    case ActuatorKind::rotational:
    case ActuatorKind::translational:
      now[0] += speed(0) * tickSeconds;
      break;
    case ActuatorKind::space:
      advance(now.data(), {speed(0), speed(1), speed(2)}, {speed(3), speed(4), speed(5)});
      break;
    case ActuatorKind::vehicle: {
      const double steering = std::clamp(actuator.command[1], -1., 1.) * actuator.speed[1];
      advance(now.data(), {speed(0), 0, 0},
              {0, 0, speed(0) * std::tan(steering) / actuator.wheelBase});
      break;
    }
  }
  return now;
}

void Actuators::move(World& world, Actuator& actuator) {
  const mjModel& model = world.model();
  const std::size_t count = coordinateCount(world, actuator);
  const Coordinates before = moved(world, actuator, 0);
  Coordinates now = moved(world, actuator, 1);
  actuator.executed = true;
  if (model.jnt_limited[actuator.joint] && count == 1) {
    const mjtNum* range = model.jnt_range + 2 * actuator.joint;
    actuator.executed = now[0] >= range[0] && now[0] <= range[1];
    now[0] = std::clamp(now[0], range[0], range[1]);
  }
  const auto isFree = [&](const Coordinates& there) {
    world.moveJoint(actuator.joint, {there.data(), count});
    return !collides(world, actuator);
  };
  const bool still = std::all_of(actuator.command.begin(), actuator.command.end(),
                                 [](double c) { return c == 0; });
  if (!still && !isFree(now)) {
    actuator.executed = false;
    world.moveJoint(actuator.joint, {before.data(), count});
    // As near to the obstacle as a part of the tick brings it.
    std::array<Coordinates, 4> nearer;
    double share = 0.5;
    for (Coordinates& there : nearer)
      there = moved(world, actuator, std::exchange(share, share / 2));
    const auto free = std::find_if(nearer.begin(), nearer.end(), isFree);
    now = free == nearer.end() ? before : *free;
  }
  world.moveJoint(actuator.joint, {now.data(), count});
  actuator.coordinates = now;
}

bool Actuators::collides(const World& world, const Actuator& actuator) const {
  const mjModel& model = world.model();
  const auto& moved = geoms_[static_cast<std::size_t>(&actuator - actuators_.data())];
  for (int other = 0; other < model.ngeom; ++other) {
    if (!isSolid(model, other) || isBelow(model, model.geom_bodyid[other], actuator.body) ||
        (model.geom_bodyid[other] != 0 && isBelow(model, actuator.body, model.geom_bodyid[other])))
      continue;
    for (const int geom : moved)
      if (geomsTouch(world, geom, other, -1e-6)) return true;
  }
  return false;
}

}  // namespace gt
