#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "Labels.h"
#include "Overlay.h"
#include "modules/perception/ColorTableFile.h"
#include "modules/perception/GT2003ImageProcessor.h"
#include "robot/logs/NaoLog.h"

namespace {

using namespace gt;

struct Options {
  std::string log, colors, labels, out;
  bool pictures = true;
};

/// The league of that log: only what vision needs (facts, 3). The ball is 86 mm wide beside the
/// field line's 50 mm in the pictures.
FieldDimensions fieldOf2009() {
  FieldDimensions field;
  field.ballRadius = 43;
  field.goalHeight = 800;
  field.yGoal = 700;
  return field;
}

/// Compares what vision found with what a person saw.
class Statistics {
 public:
  void count(const BallLabel& label, const BallPercept& ball) {
    const auto view = static_cast<std::size_t>(label.view);
    ++total_[view];
    if (!ball.seen) return;
    ++seen_[view];
    if (label.view != BallView::whole) return;
    centerError_ += (ball.centerInImage - label.center).norm();
    radiusError_ += std::abs(ball.radiusInImage - label.radius);
  }
  void print() const {
    for (const BallView view : {BallView::whole, BallView::partial, BallView::none}) {
      const auto i = static_cast<std::size_t>(view);
      fmt::print("{:8} {:3} pictures, ball found in {:3}\n", enumName(view), total_[i], seen_[i]);
    }
    if (seen_[0] > 0)
      fmt::print(
          "whole balls differ from the labels by {:.2f} pixels in the centre and {:.2f} in the "
          "radius on average\n",
          centerError_ / seen_[0], radiusError_ / seen_[0]);
  }

 private:
  std::array<int, 3> total_{}, seen_{};
  double centerError_ = 0, radiusError_ = 0;
};

void printRow(const NaoPicture& picture, const BallPercept& ball, const BallLabel* label) {
  fmt::print("{:3} {:7}  {:7}", picture.number, picture.cameraMatrix.time.ms,
             label ? enumName(label->view) : "-");
  if (!ball.seen) {
    fmt::print("  no\n");
    return;
  }
  const double difference = ball.distanceByProjection > 0 && ball.distanceBySize > 0
                                ? 100 * (ball.distanceByProjection / ball.distanceBySize - 1)
                                : 0;
  fmt::print("  yes {:6.1f} {:6.1f}  {:6.1f} {:6.1f} {:5.2f}  {:6.0f} {:6.0f} {:+6.1f}%",
             toDegrees(ball.angle.x()), toDegrees(ball.angle.y()), ball.centerInImage.x(),
             ball.centerInImage.y(), ball.radiusInImage, ball.distanceByProjection,
             ball.distanceBySize, difference);
  if (label && label->radius > 0)
    fmt::print("  label {:6.1f} {:6.1f} {:5.1f}", label->center.x(), label->center.y(),
               label->radius);
  if (std::abs(difference) > 10 && ball.distanceBySize < 1500) fmt::print("  differ");
  fmt::print("\n");
}

Result<void> replay(const Options& options) {
  const auto log = readNaoLog(options.log);
  if (!log) return log.error();
  const auto colors = readColorTable(options.colors, nao2009ColorOrder);
  if (!colors) return colors.error();
  std::vector<BallLabel> labels;
  if (!options.labels.empty()) {
    auto read = readLabels(options.labels);
    if (!read) return read.error();
    labels = *std::move(read);
  }
  if (options.pictures) std::filesystem::create_directories(options.out);

  const FieldDimensions field = fieldOf2009();
  GT2003ImageProcessor imageProcessor;
  Debug debug;
  Statistics statistics;
  Image image;
  fmt::print(
      "  #    time  label    seen  left     up       x      y     r  by projection, size, "
      "difference\n");
  for (const NaoPicture& picture : log->pictures) {
    if (auto done = log->decode(picture, image); !done) return done;
    BallPercept ball;
    LandmarksPercept landmarks;
    imageProcessor.update(image, picture.cameraMatrix, *colors, field, ball, landmarks, debug);
    const BallLabel* label = nullptr;
    for (const BallLabel& candidate : labels)
      if (candidate.picture == picture.number && candidate.time == picture.cameraMatrix.time.ms)
        label = &candidate;
    if (label) statistics.count(*label, ball);
    printRow(picture, ball, label);
    if (!options.pictures) continue;
    Overlay overlay{image};
    const Vector2d along = picture.horizonDirection * image.info.width;
    overlay.line(picture.horizon - along, picture.horizon + along, colors::white);
    if (ball.seen) overlay.circle(ball.centerInImage, ball.radiusInImage, colors::blue);
    if (auto done = overlay.write(fmt::format("{}/{:03}.png", options.out, picture.number));
        !done)
      return done;
  }
  statistics.print();
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  const char* real = std::getenv("GT_REAL");
  const std::string folder = real ? real : "../shared/real";
  Options options{folder + "/nao2009.log", folder + "/coltable-field.c64",
                  "tests/real/nao2009-labels.csv", "out/replay"};
  CLI::App app{"Looks at the pictures of a real robot's log with the robot's own vision"};
  app.add_option("--log", options.log, "the log");
  app.add_option("--colors", options.colors, "its colour table");
  app.add_option("--labels", options.labels, "what a person saw; empty for none");
  app.add_option("--out", options.out, "folder for the pictures with percepts");
  app.add_flag("!--no-pictures", options.pictures, "write none");
  CLI11_PARSE(app, argc, argv);
  const auto done = replay(options);
  if (!done) fmt::print(stderr, "{}\n", done.error().text());
  return done ? 0 : 2;
}
