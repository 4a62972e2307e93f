#include "environments/Randomization.h"

#include <algorithm>
#include <cmath>

#include "base/Number.h"
#include "simulation/scene/ProfileTable.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// Sets a number of an element, such as noise.joints.
Result<void> setNumber(SceneDescription& scene, const std::string& name, double value) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  Result<void> done = Error{.field = name, .what = "expected a number such as noise.joints"};
  const auto visit = [&](std::string_view element, auto& parameters) {
    if (element != name.substr(0, dot)) return;
    done = setByPath(parameters, dot < name.size() ? name.substr(dot + 1) : "", numberText(value));
    if (!done) done = Error{.field = name, .what = done.error().what};
  };
  forEachProfileElement(scene, visit);
  visit("dynamics", scene.dynamics);
  return done;
}

}  // namespace

Result<Randomization> Randomization::make(std::vector<RandomizedNumber> numbers,
                                          const SceneDescription& scene) {
  for (const RandomizedNumber& number : numbers) {
    if (!std::isfinite(number.low) || !std::isfinite(number.high) || number.low > number.high)
      return Error{.field = number.name, .what = "expected a lower and an upper bound"};
    if (std::ranges::count(numbers, number.name, &RandomizedNumber::name) > 1)
      return Error{.field = number.name, .what = "is given twice"};
    SceneDescription changed = scene;
    for (const double bound : {number.low, number.high})
      if (auto done = setNumber(changed, number.name, bound); !done) return done.error();
  }
  Randomization made;
  made.numbers_ = std::move(numbers);
  return made;
}

void Randomization::apply(const Random& random, SceneDescription& scene) const {
  for (const RandomizedNumber& number : numbers_)
    static_cast<void>(
        setNumber(scene, number.name, random.fork(number.name).uniform(number.low, number.high)));
}

}  // namespace gt
