// How long the simulator takes for a camera image.
#include <cstdint>

#include "CameraField.h"
#include "Parts.h"
#include "simulation/camera/CameraRenderer.h"

namespace gt {
namespace {

void takeImages(benchmark::State& state, const CameraEffects& effects) {
  const CameraField& field = CameraField::get();
  const CameraScene scene{field.model()};
  CameraRenderer renderer{scene};
  Image image;
  std::uint64_t seed = 0;
  for ([[maybe_unused]] auto _ : state) {
    const CameraView& view = field.views()[seed % field.views().size()];
    renderer.render(field.data(), view, effects, seed++, image);
    benchmark::DoNotOptimize(image.pixels.data());
  }
}

void cameraPerfect(benchmark::State& state) {
  aim(state, 1e6 / 15000);
  takeImages(state, CameraEffects::none());
}
void cameraRollingShutter(benchmark::State& state) {
  CameraEffects effects = CameraEffects::none();
  effects.rollingShutter = true;
  takeImages(state, effects);
}
void cameraNoise(benchmark::State& state) {
  aim(state, 1e6 / 8000);
  takeImages(state, {});
}

BENCHMARK(cameraPerfect)->Name("speed.camera.perfect")->Apply(inMicroseconds);
BENCHMARK(cameraRollingShutter)->Name("speed.camera.rollingShutter")->Apply(inMicroseconds);
BENCHMARK(cameraNoise)->Name("speed.camera.noise")->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
