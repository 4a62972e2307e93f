#include "Profiles.h"

#include <algorithm>

#include "base/Number.h"
#include "base/Random.h"
#include "streams/Config.h"

namespace gt {

Result<void> changeNumbers(SceneDescription& scene, const std::string& changes) {
  for (std::size_t from = 0; changes != "none" && from < changes.size();) {
    const std::size_t to = std::min(changes.find(',', from), changes.size());
    const std::string one = changes.substr(from, to - from);
    from = to + 1;
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string path = one.substr(0, equals),
                      value = one.substr(std::min(equals + 1, one.size()));
    const std::size_t slash = std::min(path.find('/'), path.size());
    Result<void> done = Error{.field = one, .what = "expected element/number=value of the profile"};
    const auto people = numberFrom<int>(value);
    if (path == "audience" && people && *people >= 0 && *people <= 200) {
      scene.audience = *people;
      done = {};
    }
    forEachProfileElement(scene, [&](std::string_view element, auto& parameters) {
      if (element == path.substr(0, slash) && slash < path.size())
        done = setByPath(parameters, path.substr(slash + 1), value);
    });
    if (!done) return done;
  }
  return {};
}

Result<SceneDescription> loadScene(const Job& job, const DataRoot& root, const std::string& path) {
  auto scene = loadScene(root.path(path));
  if (!scene) return scene;
  setProfile(*scene, profileOf(job));
  if (const auto changes = job.parameters.find("change"); changes != job.parameters.end())
    if (auto done = changeNumbers(*scene, changes->second); !done) return done.error();
  return scene;
}

Result<SceneDescription> dynamicScene(const Job& job, const DataRoot& root, std::size_t robots) {
  auto scene = loadScene(job, root);
  if (!scene) return scene;
  const double variety = job.parameters.contains("variety") ? job.number("variety") : 0.1;
  if (variety < 0 || variety > 0.9)
    return Error{.field = "variety", .what = "expected a share from 0 to 0.9"};
  Random random = Random{job.seed}.fork("dynamics");
  scene->fidelity = *enumValue<Fidelity>(job.parameter("fidelity"));
  scene->dynamics = {1 + variety * random.symmetric(), 1 + variety * random.symmetric(),
                     1 + variety * random.symmetric()};
  scene->game.referee = false;
  scene->robots.resize(robots);
  scene->balls.clear();
  return scene;
}

Result<std::unique_ptr<Match>> makeMatch(const Job& job, const DataRoot& root) {
  MatchOptions options{root};
  options.seed = job.seed;
  options.profile = job.parameter("profile");
  if (job.parameters.contains("minutes")) options.minutes = job.number("minutes");
  return Match::make(options);
}

}  // namespace gt
