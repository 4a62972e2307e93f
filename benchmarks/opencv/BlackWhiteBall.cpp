// A black and white ball, found by us (report 4.1.1) and by OpenCV's Hough transform for circles,
// in the same images.
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

#include "benchmarks/Parts.h"
#include "colors/ColorTableFile.h"
#include "measure/worlds/GameViews.h"
#include "modules/perception/specialists/BallSpotSpecialist.h"
#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

namespace gt {
namespace {

/// What robots see that look at such a ball, or elsewhere.
class Pictures {
 public:
  struct Seen {
    Image image;
    CameraMatrix matrix;
    cv::Mat gray;
  };

  Pictures() {
    auto scene = loadScene(dataRoot().path("scenes/match.scene"));
    if (!scene) throw std::runtime_error(scene.error().text());
    for (SceneBall& ball : scene->balls) ball.model = "../models/ball-black-white.xml";
    auto views = GameViews::make(dataRoot(), *scene, 1);
    if (!views) throw std::runtime_error(views.error().text());
    auto table = readColorTable(dataRoot().path("config/coltable.c64"));
    if (!table) throw std::runtime_error(table.error().text());
    colors = *table;
    for (int moment = 0; moment < 16; ++moment) {
      views->shuffle();
      for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot) {
        const GameView& view = views->look(robot, scene->camera);
        cv::Mat gray(view.image.info.height, view.image.info.width, CV_8UC1);
        for (int y = 0; y < gray.rows; ++y)
          for (int x = 0; x < gray.cols; ++x) gray.at<std::uint8_t>(y, x) = view.image.at(x, y).y;
        all.push_back({view.image, view.camera, gray});
      }
    }
  }

  std::vector<Seen> all;
  ColorTable64 colors;
};

const Pictures& pictures() {
  static const Pictures made;
  return made;
}

void ours(benchmark::State& state) {
  const Pictures& from = pictures();
  BlackWhiteBallSpecialist specialist;
  BallSpotSpecialist spotSpecialist;
  Random random{1};
  BallPercept percept;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Pictures::Seen& seen = from.all[i++ % from.all.size()];
    const Horizon horizon = horizonOf(seen.matrix);
    const CameraImage picture{seen.image, from.colors, seen.matrix, horizon};
    specialist.find(picture, 43, random, percept);
    if (!percept.seen) spotSpecialist.find(picture, 43, percept);
    benchmark::DoNotOptimize(percept);
  }
  aim(state, 30);
}

void houghCircles(benchmark::State& state) {
  cv::setNumThreads(1);
  const Pictures& from = pictures();
  std::vector<cv::Vec3f> circles;
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    cv::HoughCircles(from.all[i++ % from.all.size()].gray, circles, cv::HOUGH_GRADIENT, 1, 20, 100,
                     20, 3, 48);
    benchmark::DoNotOptimize(circles.data());
  }
}

BENCHMARK(ours)->Name("speed.vision.blackWhiteBall")->Apply(inMicroseconds);
BENCHMARK(houghCircles)->Name("speed.vision.blackWhiteBall.opencv")->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
