#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "modules/perception/ColorTableFile.h"
#include "replay/NaoReplay.h"
#include "replay/Overlay.h"

namespace {

using namespace gt;

struct Options {
  std::string log, colors, labels, out;
  bool pictures = true;
};

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
  void count(Verdict verdict) { ++verdicts_[static_cast<std::size_t>(verdict)]; }
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
    fmt::print("distances by projection and by size, nearer than 1.5 m:");
    for (std::size_t i = 1; i < verdicts_.size(); ++i)
      fmt::print(" {} {}", enumNames<Verdict>[i], verdicts_[i]);
    fmt::print("\n");
  }

 private:
  std::array<int, 3> total_{}, seen_{};
  std::array<int, enumCount<Verdict>> verdicts_{};
  double centerError_ = 0, radiusError_ = 0;
};

void printRow(const NaoPicture& picture, const BallPercept& ball, const BallLabel* label,
              Verdict verdict) {
  fmt::print("{:3} {:7}  {:7}", picture.number, picture.cameraMatrix.time.ms,
             label ? enumName(label->view) : "-");
  if (!ball.seen) {
    fmt::print("  no\n");
    return;
  }
  fmt::print("  yes {:6.1f} {:6.1f}  {:6.1f} {:6.1f} {:5.2f}  {:6.0f} {:6.0f} {:+6.1f}%",
             toDegrees(ball.angle.x()), toDegrees(ball.angle.y()), ball.centerInImage.x(),
             ball.centerInImage.y(), ball.radiusInImage, ball.distanceByProjection,
             ball.distanceBySize, 100 * differenceOfDistances(ball));
  if (label && label->radius > 0)
    fmt::print("  label {:6.1f} {:6.1f} {:5.1f}", label->center.x(), label->center.y(),
               label->radius);
  fmt::print("  {}\n", enumName(verdict));
}

const BallLabel* findLabel(const std::vector<BallLabel>& labels, const NaoPicture& picture) {
  for (const BallLabel& label : labels)
    if (label.picture == picture.number && label.time == picture.cameraMatrix.time.ms)
      return &label;
  return nullptr;
}

Result<void> run(const Options& options) {
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
  if (options.pictures) {
    std::error_code failed;
    std::filesystem::create_directories(options.out, failed);
    if (failed) return Error{options.out, 0, "", failed.message()};
  }
  NaoReplay replay{*log, *colors};
  NaoView view;
  Statistics statistics;
  fmt::print(
      "  #    time  label    seen  left     up       x      y     r  by projection, size, "
      "difference\n");
  for (const NaoPicture& picture : log->pictures) {
    if (auto done = replay.look(picture, view); !done) return done;
    const BallLabel* label = findLabel(labels, picture);
    const Verdict verdict = compareDistances(view.ball, label);
    if (label) statistics.count(*label, view.ball);
    statistics.count(verdict);
    printRow(picture, view.ball, label, verdict);
    if (!options.pictures) continue;
    Overlay overlay{view.image};
    for (const Drawing& drawing : view.drawings) overlay.draw(drawing);
    if (auto done = overlay.write(fmt::format("{}/{:03}.png", options.out, picture.number)); !done)
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
  const auto done = run(options);
  if (!done) fmt::print(stderr, "{}\n", done.error().text());
  return done ? 0 : 2;
}
