#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "simulation/scene/Scene.h"
#include "streams/Reflection.h"

namespace gt {

/// The kinds of observations: the true state, the measurements and beliefs of the agent's robot, or
/// the image of its camera.
enum class ObservationKind { state, beliefs, image };

/// The kinds of actions: angles of joints, parameters of the walk, the next motion of the robot, or
/// the part of the behavior that it executes.
enum class ActionKind { joints, parameters, motion, skills };

/// The robots that have agents: those of the red team that play, or all.
enum class AgentKind { red, all };

/// A number that each reset draws anew between two bounds (`Randomization`).
struct RandomizedNumber {
  std::string name;
  double low = 0, high = 0;

  bool operator==(const RandomizedNumber&) const = default;
  static constexpr auto fields() {
    return Fields{field<&RandomizedNumber::name>(), field<&RandomizedNumber::low>(),
                  field<&RandomizedNumber::high>()};
  }
};

/// An environment and its options. Empty texts and 0 denote the environment's own defaults.
struct EnvironmentOptions {
  std::string environment;
  std::string observations;
  std::string actions;
  std::string agents;
  std::string fidelity;
  Profile profile = Profile::benign;
  double seconds = 0;
  std::vector<RandomizedNumber> randomize;

  bool operator==(const EnvironmentOptions&) const = default;
  static constexpr auto fields() {
    using O = EnvironmentOptions;
    return Fields{
        field<&O::environment>("name of the environment, such as Walk"),
        field<&O::observations>("state, beliefs or image"),
        field<&O::actions>("joints, parameters, motion or skills"),
        field<&O::agents>("red or all"),
        field<&O::fidelity>("kinematic or dynamic"),
        field<&O::profile>("how far all is from perfect (docs/realism.md)"),
        field<&O::seconds>(Unit::s, "of simulated time until an episode is truncated", {0, 3600}),
        field<&O::randomize>("numbers that each reset draws anew")};
  }
};

}  // namespace gt
