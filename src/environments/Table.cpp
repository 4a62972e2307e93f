#include "environments/Table.h"

#include <algorithm>

#include "base/Suggestion.h"
#include "simulation/scene/ProfileTable.h"

namespace gt {
namespace {

/// The names of the elements of a list, as in "state, beliefs".
template <typename E>
std::string namesOf(const std::vector<E>& list) {
  std::string names;
  for (const E e : list) names += (names.empty() ? "" : ", ") + std::string{enumName(e)};
  return names;
}

/// Sets an empty option to the first value that an environment offers. Fails if the environment
/// does not offer the option's value.
template <typename E>
Result<void> choose(std::string& option, std::string_view name, const std::vector<E>& offered) {
  if (option.empty()) option = enumName(offered.front());
  const auto chosen = enumValue<E>(option);
  if (chosen && std::ranges::count(offered, *chosen) > 0) return {};
  std::vector<std::string> known;
  for (const E e : offered) known.emplace_back(enumName(e));
  return Error{.field = std::string{name},
               .what = "there is no '" + option + "'; expected " + namesOf(offered) +
                       suggestion(option, known)};
}

/// Chooses the fidelity in the same manner. Agents that decide angles of joints need the dynamic
/// one: in the kinematic one, legs do not move the robot.
Result<void> chooseFidelity(EnvironmentOptions& options, std::vector<Fidelity> offered) {
  if (options.actions == enumName(ActionKind::joints) &&
      std::ranges::count(offered, Fidelity::dynamic))
    offered = {Fidelity::dynamic};
  return choose(options.fidelity, "fidelity", offered);
}

}  // namespace

std::span<const EnvironmentDescription> environments() {
  static const std::vector<EnvironmentDescription> all{
      walkDescription(),    getUpDescription(),  kickDescription(),     approachDescription(),
      penaltyDescription(), goalieDescription(), localizeDescription(), soccerDescription()};
  return all;
}

Result<std::unique_ptr<Environment>> makeEnvironment(EnvironmentOptions options,
                                                     const DataRoot& root,
                                                     const Environment* same) {
  const auto all = environments();
  const auto found = std::ranges::find(all, options.environment, &EnvironmentDescription::name);
  if (found == all.end())
    return Error{.field = "environment",
                 .what = "there is no '" + options.environment + "'" +
                         suggestion(options.environment, namesIn(all))};
  if (auto done = choose(options.observations, "observations", found->observations); !done)
    return done.error();
  if (auto done = choose(options.actions, "actions", found->actions); !done) return done.error();
  if (auto done = choose(options.agents, "agents", found->agents); !done) return done.error();
  if (auto done = chooseFidelity(options, found->fidelities); !done) return done.error();
  if (options.seconds == 0) options.seconds = found->seconds;
  if (!(options.seconds > 0 && options.seconds <= 3600))
    return Error{.field = "seconds", .what = "expected a number from 0 to 3600"};
  auto scene = loadScene(root.path("scenes/match.scene"));
  if (!scene) return scene.error();
  setProfile(*scene, options.profile);
  scene->fidelity = *enumValue<Fidelity>(options.fidelity);
  auto environment = found->make(std::move(options), std::move(*scene));
  if (auto done = environment->prepare(same); !done) return done.error();
  return environment;
}

}  // namespace gt
