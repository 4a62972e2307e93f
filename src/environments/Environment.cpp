#include "environments/Environment.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "simulation/scene/ProfileTable.h"
#include "simulation/scene/SceneModel.h"

namespace gt {

Environment::Environment(EnvironmentOptions options, SceneDescription scene)
    : scene_{std::move(scene)},
      options_{std::move(options)},
      observations_{*enumValue<ObservationKind>(options_.observations)},
      actions_{*enumValue<ActionKind>(options_.actions)} {
  if (observations_ == ObservationKind::image)
    observationSpace_ = {.height = static_cast<std::size_t>(scene_.optics.height),
                         .width = static_cast<std::size_t>(scene_.optics.width)};
  else
    scene_.audience = 0;
}

Result<void> Environment::prepare(const Environment* same) {
  auto model = same ? Result<Model>{copyModel(*same->model_)} : composeModel(scene_);
  if (!model) return model.error();
  model_ = std::move(*model);
  auto randomization = Randomization::make(options_.randomize, scene_);
  if (!randomization) return randomization.error();
  randomization_ = std::move(*randomization);
  mostSteps_ = std::max(1, static_cast<int>(std::lround(options_.seconds / secondsPerStep())));
  return same ? loadFrom(*same) : load();
}

Result<void> Environment::reset(std::uint64_t seed) {
  const Random random{seed};
  SceneDescription scene = scene_;
  randomization_.apply(random.fork("randomization"), scene);
  auto simulation = Simulation::make(scene, copyModel(*model_), seed, 1, {});
  if (!simulation) return simulation.error();
  simulation_ = std::move(*simulation);
  history_.clear();
  termValues_.assign(agents_.size() * terms_.size(), 0);
  observedImages_.assign(agents_.size(), never());
  terminated_ = false;
  steps_ = 0;
  Random beginning = random.fork("begin");
  return begin(beginning);
}

void Environment::step(std::span<const float> actions) {
  history_.insert(history_.end(), actions.begin(), actions.end());
  clipped_.resize(actions.size());
  std::ranges::transform(actions, clipped_.begin(),
                         [](float a) { return std::clamp(a, -1.F, 1.F); });
  act(clipped_);
  ++steps_;
  terminated_ = judge(termValues_);
}

void Environment::observe(std::span<std::byte> into) {
  const std::size_t bytes = observationSpace_.bytes();
  for (std::size_t agent = 0; agent < agents_.size(); ++agent) {
    const auto part = into.subspan(agent * bytes, bytes);
    if (observationSpace_.isImage())
      observeImage(agent, part);
    else
      observeNumbers(agent, {reinterpret_cast<float*>(part.data()), observationSpace_.count()});
  }
}

void Environment::observeNumbers(std::size_t agent, std::span<float> numbers) {
  observe(agent, numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Component& component = observationSpace_.components[i];
    numbers[i] = std::clamp(numbers[i], static_cast<float>(component.low),
                            static_cast<float>(component.high));
  }
}

void Environment::observeImage(std::size_t agent, std::span<std::byte> into) {
  const Image& image = simulation_->image(agent);
  if (std::exchange(observedImages_[agent], image.time) == image.time) return;
  auto* byte = reinterpret_cast<std::uint8_t*>(into.data());
  for (const Pixel& pixel : image.pixels) {
    *byte++ = pixel.y;
    *byte++ = pixel.cb;
    *byte++ = pixel.cr;
  }
}

double Environment::reward(std::size_t agent) const {
  const auto first = termValues_.begin() + static_cast<std::ptrdiff_t>(agent * terms_.size());
  return std::accumulate(first, first + static_cast<std::ptrdiff_t>(terms_.size()), 0.0);
}

SceneCamera Environment::camera() const {
  SceneCamera camera;
  camera.width = 640;
  camera.height = 360;
  return camera;
}

}  // namespace gt
