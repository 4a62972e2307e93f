#include <fmt/core.h>

#include <cstdlib>
#include <filesystem>

#include "commandline/CommandLine.h"
#include "measure/real/FieldComparison.h"
#include "replay/Replay.h"
#include "replay/Track.h"
#include "views/painting/Sheet.h"

namespace {

using namespace gt;

void printHeading() {
  fmt::print(
      "  #    time  label    seen  left     up       x      y     r  by projection, size, "
      "difference\n");
}

void printRow(const NaoImage& picture, const BallPercept& ball, const BallLabel* label) {
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
  fmt::print("  {}\n", enumName(compareDistances(ball, label)));
}

Result<void> writePicture(const LogPlatform& platform, const std::string& out) {
  constexpr int scale = 2;
  Sheet sheet = imageSheet(platform.image(), scale);
  for (const Drawing& drawing : platform.drawings())
    sheet.paint(drawing, {Vector2d::Zero(), scale});
  return sheet.write(fmt::format("{}/{:03}.png", out, platform.picture().number));
}

/// Compares lines and goals, too, if there are labels of them.
class FieldWatch {
 public:
  static Result<FieldWatch> make(const std::string& labelFile) {
    FieldWatch watch;
    if (labelFile.empty()) return watch;
    auto labels = readFieldLabels(labelFile);
    if (!labels) return labels.error();
    watch.labels_ = *std::move(labels);
    return watch;
  }

  void look(const LogPlatform& platform) {
    const auto* lines = platform.robot().provided<LinesPercept>();
    const auto* landmarks = platform.robot().provided<LandmarksPercept>();
    const auto label = labels_.find(platform.picture().number);
    if (label == labels_.end() || label->second.time != platform.picture().cameraMatrix.time.ms)
      return;
    const CameraMatrix& matrix = platform.picture().cameraMatrix;
    if (lines && landmarks) comparison_.add(*lines, *landmarks, matrix, label->second);
    const MatrixFit fit{platform.robot().setup().configuration->get<FieldDimensions>()};
    comparison_.add(fit.fit(matrix, label->second.lines));
  }
  const FieldComparison& comparison() const { return comparison_; }

 private:
  std::map<int, FieldLabel> labels_;
  FieldComparison comparison_;
};

Result<void> run(const ReplayFiles& files, const std::string& fieldLabels, const std::string& out,
                 bool pictures) {
  std::error_code failed;
  std::filesystem::create_directories(out, failed);
  if (failed) return Error{.file = out, .what = failed.message()};
  auto watch = FieldWatch::make(fieldLabels);
  if (!watch) return watch.error();
  Comparison comparison;
  Track track;
  FieldDimensions field;
  const auto done = replay(files,
                           [&](const LogPlatform& platform, const BallPercept& ball,
                               const BallLabel* label) -> Result<void> {
                             if (platform.picture().number == 0) printHeading();
                             printRow(platform.picture(), ball, label);
                             comparison.add(ball, label);
                             watch->look(platform);
                             field = platform.robot().setup().configuration->get<FieldDimensions>();
                             if (const auto* pose = platform.robot().provided<RobotPose>())
                               track.add(*pose, {platform.picture().odometry});
                             return pictures ? writePicture(platform, out) : Result<void>{};
                           });
  if (!done) return done;
  fmt::print("{}{}", comparison.text(), watch->comparison().text());
  const std::string trackFile = out + ".track.svg";
  if (auto written = track.write(trackFile, field); !written) return written;
  const std::string json = out + ".json";
  Figures figures = comparison.figures();
  watch->comparison().addTo(figures);
  if (auto written = figures.write(json); !written) return written;
  fmt::print("Track: {}, figures: {}{}\n", trackFile, json,
             pictures ? ", images: " + out + "/" : "");
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line{
      argc, argv,
      "Lets a robot live on a real robot's log and compares what it sees with what a person saw"};
  const DataRoot root = line.root();
  const char* real = std::getenv("GT_REAL");
  const std::string folder = real ? real : root.path("../shared/real");
  ReplayFiles files{root};
  files.log = folder + "/nao2009.log";
  files.colors = folder + "/coltable-field.c64";
  std::string out = "out/replay", fieldLabels = root.path("tests/real/nao2009-field.csv");
  bool pictures = true;
  CLI::App& app = line.app();
  const auto* log = app.add_option("--log", files.log, "the log")->capture_default_str();
  app.add_option("--colors", files.colors, "its color table")->capture_default_str();
  app.add_option("--config", files.config, "configuration folder of its league")
      ->capture_default_str();
  app.add_option("--layout", files.layout, "which modules run")->capture_default_str();
  app.add_option("--labels", files.labels, "the balls that a person saw; empty for none")
      ->capture_default_str();
  app.add_option("--field-labels", fieldLabels, "lines and goals that a person saw; empty for none")
      ->capture_default_str();
  app.add_option("--out", out, "folder for the images with percepts; the figures go to OUT.json")
      ->capture_default_str();
  app.add_flag("!--no-pictures", pictures, "write none");
  return line.run([&]() -> Result<void> {
    if (log->count() > 0 || std::filesystem::exists(files.log))
      return run(files, fieldLabels, out, pictures);
    // The log is not part of the repository: without it there is nothing to do, and nothing wrong.
    fmt::print("replay: no real robot's log at {}, nothing to look at\n", files.log);
    return {};
  });
}
