#include "console/ConsoleRobot.h"

#include <algorithm>
#include <filesystem>
#include <ranges>

#include "match/SimulatedRobot.h"
#include "robot/logs/LogPlatform.h"
#include "robot/logs/ReplayPlatform.h"
#include "streams/Mcap.h"

namespace gt {
namespace {

class RobotOfScene : public ConsoleRobot {
 public:
  RobotOfScene(SimulatedRobot& robot, std::size_t index)
      : ConsoleRobot{robot.name()}, robot_{robot}, index_{index} {
    robot_.sendOracle(true);
    robot_.observe([this](const RobotInput& input, const MessageQueue& messages) {
      memory().take(messages, input.image);
    });
  }
  Robot* robot() override { return &robot_.robot(); }
  std::optional<std::size_t> index() const override { return index_; }
  SimulatedRobot* simulated() override { return &robot_; }
  MessageQueue& fromTools() override { return robot_.robot().fromTools(); }

 private:
  SimulatedRobot& robot_;
  std::size_t index_;
};

/// What both kinds of logs have in common.
class RobotOnLog : public ConsoleRobot {
 public:
  RobotOnLog(const std::string& name, Time begin) : ConsoleRobot{name}, begin_{begin} {}
  MessageQueue& fromTools() override { return robot()->fromTools(); }

 protected:
  /// Takes what the robot told, and the picture that it saw.
  void listen(const Image* picture) {
    memory().take(robot()->toTools(), picture);
    robot()->toTools().clear();
  }
  /// How long the log has been running, ms.
  std::int64_t played(Time now) const { return now - begin_; }

 private:
  Time begin_;
};

class RobotOnRecordedLog : public RobotOnLog {
 public:
  RobotOnRecordedLog(const std::string& name, Time begin, ReplayPlatform platform)
      : RobotOnLog{name, begin}, platform_{std::move(platform)} {}
  Robot* robot() override { return &platform_.robot(); }
  Result<void> step(Time now) override {
    while (!ended_ && (!first_ || platform_.now() - *first_ < played(now))) {
      const auto more = platform_.step();
      ended_ = !more || !*more;
      if (!more) return more.error();
      if (ended_) break;
      if (!first_) first_ = platform_.now();
      const auto picture = robot()->value("Image");
      listen(picture ? static_cast<const Image*>(picture->data()) : nullptr);
    }
    return {};
  }

 private:
  ReplayPlatform platform_;
  std::optional<Time> first_;
  bool ended_ = false;
};

class RobotOnNaoLog : public RobotOnLog {
 public:
  static Result<std::unique_ptr<ConsoleRobot>> make(
      const std::string& name, Time begin, const std::string& file,
      const std::shared_ptr<const Configuration>& configuration, const Layout& layout) {
    auto log = readNaoLog(file);
    if (!log) return log.error();
    std::unique_ptr<RobotOnNaoLog> robot{new RobotOnNaoLog{name, begin, std::move(*log)}};
    auto platform = LogPlatform::make(robot->log_, {configuration, layout, {}});
    if (!platform) return platform.error();
    robot->platform_.emplace(std::move(*platform));
    return std::unique_ptr<ConsoleRobot>{std::move(robot)};
  }
  Robot* robot() override { return &platform_->robot(); }
  Result<void> step(Time now) override {
    while (!platform_->finished() && (!first_ || time_ - *first_ < played(now))) {
      if (auto done = platform_->step(); !done) return done;
      time_ = platform_->image().time;
      if (!first_) first_ = time_;
      listen(&platform_->image());
    }
    return {};
  }

 private:
  RobotOnNaoLog(const std::string& name, Time begin, NaoLog log)
      : RobotOnLog{name, begin}, log_{std::move(log)} {}

  NaoLog log_;
  std::optional<LogPlatform> platform_;
  std::optional<Time> first_;
  Time time_;
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
Result<std::shared_ptr<const Configuration>> naoConfiguration(const std::string& file) {
  ConfigurationPaths paths;
  paths.config = "config/nao2009";
  paths.colorTable = "config/coltable.c64";
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

std::unique_ptr<ConsoleRobot> makeSimulatedRobot(SimulatedRobot& robot, std::size_t index) {
  return std::make_unique<RobotOfScene>(robot, index);
}

Result<std::unique_ptr<ConsoleRobot>> makeLogRobot(const std::string& name, const std::string& file,
                                                   const Configuration& configuration, Time begin) {
  if (!std::filesystem::is_regular_file(file)) return Error{file, 0, "", "there is no such file"};
  const std::string replayLayout = "layouts/replay.layout";
  const auto layout = loadLayout(replayLayout);
  if (!layout) return layout.error();
  if (!McapReader::open(file)) {
    const auto nao = naoConfiguration(file);
    if (!nao) return nao.error();
    return RobotOnNaoLog::make(name, begin, file, *nao, *layout);
  }
  // As the log's own robot was, or else as far as what was recorded suffices.
  auto platform = ReplayPlatform::make({file});
  if (!platform)
    platform = ReplayPlatform::make({file, configurationFor(*layout, configuration), replayLayout});
  if (!platform) return platform.error();
  return std::unique_ptr<ConsoleRobot>{
      std::make_unique<RobotOnRecordedLog>(name, begin, std::move(*platform))};
}

}  // namespace gt
