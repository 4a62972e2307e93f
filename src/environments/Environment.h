#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "base/Random.h"
#include "base/Result.h"
#include "environments/EnvironmentOptions.h"
#include "environments/Randomization.h"
#include "environments/Space.h"
#include "simulation/Simulation.h"
#include "views/ScenePicture.h"

namespace gt {

/// One world in which agents act and are rewarded, in the sense of Gymnasium and PettingZoo.
///
/// An episode is determined by the options, the seed of its reset and the actions since, to the
/// last bit. Lengths are m, times s and angles rad here, so that numbers lie around 1.
class Environment {
 public:
  virtual ~Environment() = default;
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

  const EnvironmentOptions& options() const { return options_; }
  /// The names of the agents: those of their robots, which are the first ones of the scene. All
  /// have the same spaces.
  const std::vector<std::string>& agents() const { return agents_; }
  const Space& actionSpace() const { return actionSpace_; }
  const Space& observationSpace() const { return observationSpace_; }
  /// The terms whose sum is each agent's reward.
  const std::vector<RewardTerm>& terms() const { return terms_; }
  double secondsPerStep() const { return static_cast<double>(ticksPerStep_) * tickSeconds; }

  /// Begins an episode. Fails if the files of the scene cannot be read any more.
  Result<void> reset(std::uint64_t seed);
  /// Takes one step with the actions of all agents, in their order. Each number is clipped to -1 to
  /// 1 and must be finite. Not to be called after the end of an episode.
  void step(std::span<const float> actions);

  /// Writes the present observations of all agents, in their order. `into` must be the same memory
  /// in each call, since an image that it already holds is not written again.
  void observe(std::span<std::byte> into);
  /// The reward of one agent in the last step: the sum of its terms.
  double reward(std::size_t agent) const;
  /// The terms of the last step: those of the first agent, then those of the next one.
  std::span<const double> termValues() const { return termValues_; }
  /// Whether the task is over: done or failed.
  bool terminated() const { return terminated_; }
  /// Whether the time is over.
  bool truncated() const { return !terminated_ && steps_ >= mostSteps_; }

  /// An image of the scene.
  RgbImage picture() const { return scenePicture(simulation_->world(), camera()); }
  /// The actions since the last reset. Together with the seed they are the environment's state.
  const std::vector<float>& history() const { return history_; }
  std::uint64_t fingerprint() const { return simulation_->fingerprint(); }
  /// The true state of the world. To be called after `reset`.
  const World& world() const { return simulation_->world(); }

 protected:
  Environment(EnvironmentOptions options, SceneDescription scene);

  /// Completes the construction once the constructor has defined scene, agents and spaces: reads
  /// the files, or takes their content from `same`, an environment with the same options.
  Result<void> prepare(const Environment* same);
  friend Result<std::unique_ptr<Environment>> makeEnvironment(EnvironmentOptions options,
                                                              const DataRoot& root,
                                                              const Environment* same);

  /// Reads the files that it needs beside the scene, once.
  virtual Result<void> load() { return {}; }
  /// Takes the content of these files from an environment of the same class instead.
  virtual Result<void> loadFrom(const Environment&) { return load(); }
  /// Places robots and balls and attaches the robots' controllers, in a new simulation.
  virtual Result<void> begin(Random& random) = 0;
  /// Applies the agents' actions for one step of the environment: calls `tick` `ticksPerStep_`
  /// times.
  virtual void act(std::span<const float> actions) = 0;
  /// Writes the observed numbers of one agent, if it does not observe an image.
  virtual void observe(std::size_t agent, std::span<float> numbers) = 0;
  /// Fills the terms of all agents after a step; returns whether the task is over.
  virtual bool judge(std::span<double> terms) = 0;
  /// The camera of `picture`.
  virtual SceneCamera camera() const;

  ObservationKind observations() const { return observations_; }
  ActionKind actions() const { return actions_; }
  Simulation& simulation() { return *simulation_; }
  const Simulation& simulation() const { return *simulation_; }
  World& world() { return simulation_->world(); }
  void tick() { simulation_->step(); }

  SceneDescription scene_;
  std::vector<std::string> agents_;
  Space actionSpace_, observationSpace_;
  std::vector<RewardTerm> terms_;
  int ticksPerStep_ = 1;  ///< Ticks that `act` takes.

 private:
  /// Writes an agent's observed numbers, clipped to the bounds of its space.
  void observeNumbers(std::size_t agent, std::span<float> numbers);
  void observeImage(std::size_t agent, std::span<std::byte> into);

  EnvironmentOptions options_;
  ObservationKind observations_;
  ActionKind actions_;
  Randomization randomization_;
  Model model_;  ///< The scene's model; each episode begins with a copy.
  std::unique_ptr<Simulation> simulation_;
  std::vector<float> history_;
  std::vector<float> clipped_;
  std::vector<double> termValues_;
  std::vector<Time> observedImages_;  ///< Time of the image written last, for each agent.
  bool terminated_ = false;
  int steps_ = 0, mostSteps_ = 0;
};

/// A description of one of the `environments`.
struct EnvironmentDescription {
  std::string_view name;  ///< Such as Walk.
  std::string_view summary;
  std::vector<ObservationKind> observations;  ///< The first one is the default.
  std::vector<ActionKind> actions;            ///< The first one is the default.
  std::vector<AgentKind> agents;              ///< The first one is the default.
  std::vector<Fidelity> fidelities;           ///< The first one is the default, except with joints.
  double seconds;                             ///< Time after which episodes are truncated.
  std::string_view end;                       ///< What terminates an episode.
  std::unique_ptr<Environment> (*make)(EnvironmentOptions options, SceneDescription scene);
};

/// All environments.
std::span<const EnvironmentDescription> environments();

/// Makes an environment with options, which are completed by its defaults; it has to be reset.
/// `same`, an environment with the same options, saves the reading of files. Fails if there is no
/// such environment or option.
Result<std::unique_ptr<Environment>> makeEnvironment(EnvironmentOptions options,
                                                     const DataRoot& root,
                                                     const Environment* same = nullptr);

}  // namespace gt
