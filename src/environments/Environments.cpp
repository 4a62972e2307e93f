#include "environments/Environments.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include "streams/Json.h"

namespace gt {
namespace {

/// The state that `save` writes.
struct EnvironmentState {
  EnvironmentOptions options;
  std::uint64_t seed = 0;
  std::int64_t episodes = 0;
  std::vector<float> actions;
  std::uint64_t fingerprint = 0;

  static constexpr auto fields() {
    using S = EnvironmentState;
    return Fields{
        field<&S::options>(), field<&S::seed>("last given seed"),
        field<&S::episodes>("number of episodes begun since the seed was given", {1, 1e15}),
        field<&S::actions>("actions since the last reset"),
        field<&S::fingerprint>("fingerprint of the world")};
  }
};

/// The seed of an episode. That of the first episode differs from `seed` itself, so that worlds
/// with neighboring seeds share no episode.
std::uint64_t episodeSeed(std::uint64_t seed, std::int64_t episode) {
  return Random{seed}.fork(std::to_string(episode))();
}

}  // namespace

Result<std::unique_ptr<Environments>> Environments::make(const EnvironmentOptions& options,
                                                         const DataRoot& root, std::size_t count,
                                                         std::size_t threads) {
  constexpr std::size_t most = 10'000, mostThreads = 256;
  if (count < 1 || count > most)
    return Error{.field = "count", .what = "expected a number from 1 to 10000"};
  if (threads > mostThreads)
    return Error{.field = "threads", .what = "expected a number from 0 to 256"};
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  std::unique_ptr<Environments> made{new Environments{std::min(threads, count)}};
  for (std::size_t i = 0; i < count; ++i) {
    auto environment = makeEnvironment(options, root, i == 0 ? nullptr : &made->first());
    if (!environment) return environment.error();
    made->worlds_.push_back({std::move(*environment)});
  }
  const std::size_t agents = made->agents();
  made->observations_.resize(count * agents * made->first().observationSpace().bytes());
  made->rewards_.resize(count * agents);
  made->terms_.resize(count * agents * made->first().terms().size());
  made->terminated_.resize(count);
  made->truncated_.resize(count);
  if (auto done = made->resetAll(0); !done) return done.error();
  return made;
}

Result<void> Environments::reset(std::size_t world, std::optional<std::uint64_t> seed) {
  World& w = worlds_[world];
  if (seed) {
    w.seed = *seed;
    w.episodes = 0;
  }
  auto done = w.environment->reset(episodeSeed(w.seed, w.episodes++));
  publish(world);
  return done;
}

Result<void> Environments::resetAll(std::optional<std::uint64_t> seed) {
  pool_.forEach(count(), [&](std::size_t world, std::size_t) {
    const auto own = seed ? std::optional{*seed + world} : std::nullopt;
    if (auto done = reset(world, own); !done) worlds_[world].error = done.error();
  });
  return firstError();
}

Result<void> Environments::step(std::span<const float> actions, bool autoreset) {
  if (actions.size() != count() * agents() * first().actionSpace().count())
    return Error{.field = "actions", .what = "of another shape"};
  if (!std::ranges::all_of(actions, [](float number) { return std::isfinite(number); }))
    return Error{.field = "actions", .what = "contain a number that is not finite"};
  if (!autoreset)
    for (std::size_t world = 0; world < count(); ++world)
      if (isOver(world))
        return Error{.field = "step", .what = "the episode is over; reset the environment"};
  pool_.forEach(count(), [&](std::size_t world, std::size_t) {
    const std::size_t share = actions.size() / count();
    run(world, actions.subspan(world * share, share));
  });
  return firstError();
}

void Environments::run(std::size_t world, std::span<const float> actions) {
  if (isOver(world)) {
    if (auto done = reset(world, std::nullopt); !done) worlds_[world].error = done.error();
    return;
  }
  worlds_[world].environment->step(actions);
  publish(world);
}

void Environments::publish(std::size_t world) {
  Environment& environment = *worlds_[world].environment;
  const std::size_t all = agents(), bytes = all * environment.observationSpace().bytes();
  environment.observe(observations().subspan(world * bytes, bytes));
  for (std::size_t agent = 0; agent < all; ++agent)
    rewards_[world * all + agent] = environment.reward(agent);
  std::ranges::copy(environment.termValues(),
                    terms().subspan(world * environment.termValues().size()).begin());
  terminated_[world] = environment.terminated();
  truncated_[world] = environment.truncated();
}

Result<void> Environments::firstError() {
  for (World& world : worlds_)
    if (world.error) {
      const Error error = *world.error;
      world.error.reset();
      return error;
    }
  return {};
}

std::string Environments::save(std::size_t world) const {
  const World& w = worlds_[world];
  return jsonText(EnvironmentState{w.environment->options(), w.seed, w.episodes,
                                   w.environment->history(), w.environment->fingerprint()});
}

Result<void> Environments::load(std::size_t world, const std::string& text) {
  EnvironmentState state;
  if (const auto done = readJson(text, "state", state); !done) return done.error();
  World& w = worlds_[world];
  if (state.options != w.environment->options())
    return Error{.field = "options", .what = "are those of another environment"};
  const std::size_t share = agents() * first().actionSpace().count();
  if (state.episodes < 1 || state.actions.size() % share != 0 ||
      !std::ranges::all_of(state.actions, [](float number) { return std::isfinite(number); }))
    return Error{.field = "actions", .what = "are not those of this environment"};
  w.seed = state.seed;
  w.episodes = state.episodes - 1;
  auto done = reset(world, std::nullopt);
  const std::span<const float> actions{state.actions};
  for (std::size_t i = 0; done && i < actions.size(); i += share) {
    if (isOver(world)) return Error{.field = "actions", .what = "go on after the episode's end"};
    run(world, actions.subspan(i, share));
  }
  if (done && w.environment->fingerprint() != state.fingerprint)
    return Error{.field = "fingerprint",
                 .what = "the episode went another way: files or the program have changed"};
  return done;
}

}  // namespace gt
