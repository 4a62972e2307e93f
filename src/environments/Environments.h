#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "environments/Environment.h"
#include "simulation/WorkerPool.h"

namespace gt {

/// Many worlds of one kind in one process, stepped by several threads. Observations, rewards and
/// ends of episodes lie in arrays of all worlds, where callers read them without a copy: world by
/// world, and in a world agent by agent. The number of threads does not influence the results.
class Environments {
 public:
  /// `threads` 0: as many as there are cores. Fails as `makeEnvironment` does.
  static Result<std::unique_ptr<Environments>> make(const EnvironmentOptions& options,
                                                    const DataRoot& root, std::size_t count,
                                                    std::size_t threads);

  std::size_t count() const { return worlds_.size(); }
  std::size_t agents() const { return first().agents().size(); }
  const Environment& first() const { return *worlds_.front().environment; }

  /// Begins an episode in one world. Its seed is derived from `seed`; without one, it is the next
  /// in the sequence derived from the last given seed (0 if none was given).
  Result<void> reset(std::size_t world, std::optional<std::uint64_t> seed);
  /// Begins an episode in each world, with the seeds `seed`, `seed` + 1 and so on.
  Result<void> resetAll(std::optional<std::uint64_t> seed);
  /// Takes one step in each world, with the actions of all agents of all worlds. If `autoreset`, a
  /// world whose episode is over begins a new one instead, without a reward (Gymnasium's autoreset
  /// in the next step); otherwise that is an error. Actions that are not finite are an error, too,
  /// and change nothing.
  Result<void> step(std::span<const float> actions, bool autoreset);

  /// Observations, rewards and their terms after the last step or reset.
  std::span<std::byte> observations() { return observations_; }
  std::span<double> rewards() { return rewards_; }
  std::span<double> terms() { return terms_; }
  /// Whether the episode of each world was terminated, or truncated.
  std::span<std::uint8_t> terminated() { return terminated_; }
  std::span<std::uint8_t> truncated() { return truncated_; }

  RgbImage picture(std::size_t world) const { return worlds_[world].environment->picture(); }

  /// The state of a world as text: options, seed, and the actions since the reset.
  std::string save(std::size_t world) const;
  /// Continues a world with the same bits from a text of `save`: its episode is played again.
  /// Fails, and changes nothing, if the text is not of an environment with the same options. If the
  /// result is another state, because files or programs have changed, fails and keeps that state.
  Result<void> load(std::size_t world, const std::string& text);

 private:
  struct World {
    std::unique_ptr<Environment> environment;
    std::uint64_t seed = 0;     ///< The last given seed.
    std::int64_t episodes = 0;  ///< Number of episodes begun since `seed` was given.
    std::optional<Error> error{};
  };

  explicit Environments(std::size_t threads) : pool_{threads} {}
  void run(std::size_t world, std::span<const float> actions);
  /// Copies the results of a world into the arrays.
  void publish(std::size_t world);
  Result<void> firstError();
  bool isOver(std::size_t world) const { return terminated_[world] || truncated_[world]; }

  std::vector<World> worlds_;
  std::vector<std::byte> observations_;
  std::vector<double> rewards_, terms_;
  std::vector<std::uint8_t> terminated_, truncated_;
  WorkerPool pool_;
};

}  // namespace gt
