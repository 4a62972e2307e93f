#include "console/ConsoleRobot.h"

#include <algorithm>
#include <filesystem>
#include <ranges>

#include "match/SimulatedRobot.h"
#include "robot/LocalLink.h"
#include "robot/logs/LogPlatform.h"
#include "robot/logs/ReplayPlatform.h"
#include "streams/Mcap.h"

namespace gt {
namespace {

class RobotOfScene : public ConsoleRobot {
 public:
  RobotOfScene(SimulatedRobot& robot, std::size_t index)
      : ConsoleRobot{robot.name(), robot.link()}, robot_{robot}, index_{index} {
    robot_.sendOracle(true);
    robot_.observe([this](const MessageQueue& messages) { observed().take(messages); });
  }
  std::optional<std::size_t> index() const override { return index_; }
  SimulatedRobot* simulated() override { return &robot_; }

 private:
  SimulatedRobot& robot_;
  std::size_t index_;
};

/// A robot on a log; the session's time tells how far it has come.
template <typename Platform>
class RobotOnLog : public ConsoleRobot {
 public:
  RobotOnLog(const std::string& name, Time begin, std::unique_ptr<Platform> platform)
      : ConsoleRobot{name, std::make_unique<LocalLink>(platform->robot())},
        platform_{std::move(platform)},
        begin_{begin} {}

  Result<void> step(Time now) override {
    while (!ended_ && (!first_ || platform_->now() - *first_ < now - begin_)) {
      const auto more = platform_->step();
      ended_ = !more || !*more;
      if (!more) return more.error();
      if (ended_) return Error{.field = name(), .what = "its log has ended"};
      if (!first_) first_ = platform_->now();
      observed().take(platform_->robot().toTools());
      platform_->robot().toTools().clear();
    }
    return {};
  }

 private:
  std::unique_ptr<Platform> platform_;
  Time begin_;
  std::optional<Time> first_;
  bool ended_ = false;
};

/// The platform of a log of 2009 with its log.
class NaoPlatform {
 public:
  static Result<std::unique_ptr<NaoPlatform>> make(
      const std::string& file, const std::shared_ptr<const Configuration>& configuration,
      const Layout& layout) {
    auto log = readNaoLog(file);
    if (!log) return log.error();
    std::unique_ptr<NaoPlatform> made{new NaoPlatform{std::move(*log)}};
    auto platform = LogPlatform::make(made->log_, {configuration, layout, {}});
    if (!platform) return platform.error();
    made->platform_.emplace(std::move(*platform));
    return made;
  }
  Robot& robot() { return platform_->robot(); }
  Time now() const { return platform_->image().time; }
  Result<bool> step() {
    if (platform_->finished()) return false;
    if (auto done = platform_->step(); !done) return done.error();
    return true;
  }

 private:
  explicit NaoPlatform(NaoLog log) : log_{std::move(log)} {}

  NaoLog log_;
  std::optional<LogPlatform> platform_;
};

/// What of a configuration concerns the tasks of a layout.
std::shared_ptr<const Configuration> configurationFor(const Layout& layout,
                                                      const Configuration& whole) {
  auto part = std::make_shared<Configuration>(whole);
  const auto elsewhere = [&](const auto& choice) {
    for (const ProcessLayout& process : layout.processes)
      for (const ProcessLayout::Group& group : process.groups)
        if (std::ranges::find(group.tasks, choice.task) != group.tasks.end()) return false;
    return true;
  };
  std::erase_if(part->solutions, elsewhere);
  return part;
}

/// The configuration for logs of 2009, with the colour table that lies beside the log, if any.
Result<std::shared_ptr<const Configuration>> naoConfiguration(const std::string& file,
                                                              const DataRoot& root) {
  ConfigurationPaths paths = ConfigurationPaths::in(root);
  paths.config = root.path("config/nao2009");
  paths.colorTable = root.path("config/coltable.c64");
  std::vector<std::string> tables;
  std::error_code failed;
  const auto folder = std::filesystem::absolute(file).parent_path();
  for (const auto& entry : std::filesystem::directory_iterator{folder, failed})
    if (entry.path().extension() == ".c64") tables.push_back(entry.path().string());
  if (!tables.empty()) {
    paths.colorTable = *std::ranges::max_element(tables);
    paths.colorOrder = nao2009ColorOrder;
  }
  return loadConfiguration(paths);
}

}  // namespace

ConsoleRobot::ConsoleRobot(std::string name, std::unique_ptr<RobotLink> link)
    : observed_{std::move(name), std::move(link)} {
  observed_.passTo([this](const MessageQueue& messages) {
    if (!recording.take(messages)) observed_.addText("the recording is full and ends");
  });
}

std::unique_ptr<ConsoleRobot> makeSimulatedRobot(SimulatedRobot& robot, std::size_t index) {
  return std::make_unique<RobotOfScene>(robot, index);
}

Result<std::unique_ptr<ConsoleRobot>> makeLogRobot(const std::string& name, const std::string& file,
                                                   const Configuration& configuration, Time begin,
                                                   const DataRoot& root) {
  if (!std::filesystem::is_regular_file(file)) return Error{file, 0, "", "there is no such file"};
  const std::string replayLayout = root.path("layouts/replay.layout");
  const auto layout = loadLayout(replayLayout);
  if (!layout) return layout.error();
  if (!McapReader::open(file)) {
    const auto nao = naoConfiguration(file, root);
    if (!nao) return nao.error();
    auto platform = NaoPlatform::make(file, *nao, *layout);
    if (!platform) return platform.error();
    return std::unique_ptr<ConsoleRobot>{
        std::make_unique<RobotOnLog<NaoPlatform>>(name, begin, std::move(*platform))};
  }
  // As the log's own robot was, or else as far as what was recorded suffices.
  auto platform = ReplayPlatform::make({file});
  if (!platform)
    platform = ReplayPlatform::make({file, configurationFor(*layout, configuration), replayLayout});
  if (!platform) return platform.error();
  return std::unique_ptr<ConsoleRobot>{std::make_unique<RobotOnLog<ReplayPlatform>>(
      name, begin, std::make_unique<ReplayPlatform>(std::move(*platform)))};
}

}  // namespace gt
