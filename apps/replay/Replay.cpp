#include "replay/Replay.h"

namespace gt {
namespace {

/// What is drawn on the images.
constexpr const char* drawings[] = {"ImageProcessor/horizon", "ImageProcessor/percepts"};

Result<LogPlatform> makePlatform(const ReplayFiles& files, const NaoLog& log) {
  ConfigurationPaths paths = ConfigurationPaths::in(files.root);
  paths.config = files.config;
  paths.colorTable = files.colors;
  paths.colorOrder = nao2009ColorOrder;
  auto configuration = loadConfiguration(paths);
  if (!configuration) return configuration.error();
  auto layout = loadLayout(files.layout);
  if (!layout) return layout.error();
  RobotSetup setup;
  setup.configuration = *configuration;
  setup.layout = *layout;
  auto platform = LogPlatform::make(log, setup);
  if (!platform) return platform.error();
  for (const char* key : drawings)
    if (auto done = platform->robot().request(DebugRequest{key, DebugKeyMode::always}); !done)
      return done.error();
  if (!platform->robot().provided<BallPercept>())
    return Error{.file = files.layout,
                 .field = "ImageProcessor",
                 .what = "no process runs it, so no ball can be seen"};
  return platform;
}

/// The label of an image; null if a person did not look at this one.
const BallLabel* find(const std::vector<BallLabel>& labels, const NaoImage& picture) {
  for (const BallLabel& label : labels)
    if (label.picture == picture.number && label.time == picture.cameraMatrix.time.ms)
      return &label;
  return nullptr;
}

}  // namespace

Result<void> replay(const ReplayFiles& files, const ReplayVisitor& look) {
  const auto log = readNaoLog(files.log);
  if (!log) return log.error();
  auto platform = makePlatform(files, *log);
  if (!platform) return platform.error();
  std::vector<BallLabel> labels;
  if (!files.labels.empty()) {
    auto read = readLabels(files.labels);
    if (!read) return read.error();
    labels = *std::move(read);
  }
  const BallPercept& ball = *platform->robot().provided<BallPercept>();
  while (!platform->finished()) {
    if (auto done = platform->step(); !done) return done;
    if (auto done = look(*platform, ball, find(labels, platform->picture())); !done) return done;
  }
  if (!log->damage.empty()) return log->damage.front();
  return {};
}

}  // namespace gt
