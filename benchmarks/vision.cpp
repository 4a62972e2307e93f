// How long vision takes for an image, beside the bare classification of all its pixels. Beside
// OpenCV: opencv/Segmentation.cpp.
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "GameImages.h"
#include "Parts.h"
#include "colors/ColorTableFile.h"
#include "measure/worlds/GameViews.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/testing/FoundPercepts.h"

namespace gt {
namespace {

std::vector<GameImage> takeImages() {
  const auto scene = loadScene(dataRoot().path("scenes/match.scene"));
  if (!scene) throw std::runtime_error(scene.error().text());
  auto views = GameViews::make(dataRoot(), *scene, 1);
  if (!views) throw std::runtime_error(views.error().text());
  std::vector<GameImage> pictures;
  for (int moment = 0; moment < 8; ++moment) {
    views->shuffle();
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot) {
      const GameView& view = views->look(robot, scene->camera);
      pictures.push_back({view.image, view.camera});
    }
  }
  return pictures;
}

std::unique_ptr<const ColorTable64> readColors() {
  const auto colors = readColorTable(dataRoot().path("config/coltable.c64"));
  if (!colors) throw std::runtime_error(colors.error().text());
  return std::make_unique<const ColorTable64>(*colors);
}

void imageProcessor(benchmark::State& state) {
  GT2003ImageProcessor processor;
  const FieldDimensions field;
  FoundPercepts found;
  Debug debug;
  const std::vector<GameImage>& pictures = gameImages();  // taken before time is measured
  const ColorTable64& colors = gameColors();
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const GameImage& picture = pictures[i++ % pictures.size()];
    processor.update(picture.image, picture.camera, colors, field, found, debug);
    benchmark::DoNotOptimize(&found);
  }
}

void classifyAll(benchmark::State& state) {
  std::vector<ColorClass> classes(gameImages().front().image.pixels.size());
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Image& image = gameImages()[i++ % gameImages().size()].image;
    for (std::size_t k = 0; k < classes.size(); ++k) classes[k] = gameColors()[image.pixels[k]];
    benchmark::ClobberMemory();
  }
}

BENCHMARK(imageProcessor)->Name("speed.vision.gt2003")->Apply(inMicroseconds);
BENCHMARK(classifyAll)->Name("speed.vision.classifyAll")->Apply(inMicroseconds);

}  // namespace

const std::vector<GameImage>& gameImages() {
  static const std::vector<GameImage> pictures = takeImages();
  return pictures;
}

const ColorTable64& gameColors() {
  static const std::unique_ptr<const ColorTable64> colors = readColors();
  return *colors;
}

}  // namespace gt
