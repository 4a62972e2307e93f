#include "observer/robots/LogRobot.h"

#include <algorithm>
#include <filesystem>

#include "debug/Drawing.h"
#include "logs/ImportNaoLog.h"
#include "logs/NaoLog.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// The configuration for logs of 2009, with the color table that lies beside the log.
Result<std::shared_ptr<const Configuration>> naoConfiguration(const std::string& file,
                                                              const LogRobotOptions& options) {
  const std::string& colorTable = options.colorTable;
  ConfigurationPaths paths = ConfigurationPaths::in(options.root);
  paths.config = options.root.path("config/nao2009");
  paths.colorTable = colorTable;
  paths.colorOrder = nao2009ColorOrder;
  std::vector<std::string> tables;
  std::error_code failed;
  const auto folder = fs::absolute(file).parent_path();
  for (const auto& entry : fs::directory_iterator{folder, failed})
    if (entry.path().extension() == ".c64") tables.push_back(entry.path().filename().string());
  std::ranges::sort(tables);
  if (colorTable.empty() && tables.size() > 1) {
    std::string names;
    for (const std::string& table : tables) names += (names.empty() ? "" : ", ") + table;
    return Error{.file = file, .what = "several color tables lie beside it, name one: " + names};
  }
  if (colorTable.empty() && tables.size() == 1)
    paths.colorTable = (folder / tables.front()).string();
  if (paths.colorTable.empty()) {
    paths.colorTable = options.root.path("config/coltable.c64");
    paths.colorOrder = gt2003ColorOrder;
  } else if (!fs::exists(paths.colorTable)) {
    paths.colorTable = (folder / paths.colorTable).string();
  }
  return loadConfiguration(paths);
}

/// What asks for something once, and need not be asked again of a robot that begins anew.
bool asksOnce(const Message& message) {
  WatchRequest watch;
  return message.is<DescriptionRequest>() || message.is<SetupRequest>() ||
         (message.is<WatchRequest>() && message.read(watch) && watch.mode == DebugKeyMode::times);
}

}  // namespace

Result<OpenedLog> openLog(const std::string& file, const LogRobotOptions& options,
                          const std::vector<Configuration::SolutionChoice>& solutions) {
  const auto recorded = McapReader::open(file);
  if (!recorded && !isNaoLog(file)) return recorded.error();
  std::unique_ptr<TemporaryFolder> converted;
  const auto make = [&](const std::string& log, std::shared_ptr<const Configuration> configuration,
                        const std::string& layout) -> Result<OpenedLog> {
    auto platform = ReplayPlatform::make({log, std::move(configuration), layout, solutions});
    if (!platform) return platform.error();
    return OpenedLog{file, std::move(converted), std::move(*platform), {}};
  };
  const std::string replay = options.root.path("layouts/replay.layout");
  if (recorded) {
    if (const auto setup = recordedSetup(*recorded, file); setup && !setup->files.empty())
      return make(file, {}, {});
    // As far as what was recorded suffices.
    if (auto opened = make(file, options.configuration, options.root.path("layouts/cmd.layout")))
      return opened;
    return make(file, options.configuration, replay);
  }
  converted = std::make_unique<TemporaryFolder>();
  const std::string copy = (converted->path() / "log.mcap").string();
  const auto left = importNaoLog(file, copy);
  if (!left) return left.error();
  const auto configuration = naoConfiguration(file, options);
  if (!configuration) return configuration.error();
  auto opened = make(copy, *configuration, replay);
  if (!opened) {
    Error error = opened.error();
    if (error.file == copy) error.file = file;
    return error;
  }
  opened->warnings = *left;
  return opened;
}

/// Messages wait here until they are exchanged, so that those can be refused that make no sense.
class LogRobot::Link : public RobotLink {
 public:
  explicit Link(LogRobot& robot) : robot_{robot} {}
  MessageQueue& toRobot() override { return robot_.toRobot_; }
  void exchange(const Taker& take) override {
    MessageQueue answers{1 << 16};
    std::vector<SolutionRequest> solutions;
    robot_.toRobot_.handleAllMessages([&](const Message& message) {
      if (robot_.refuses(message, answers)) return;
      SolutionRequest request;
      if (message.is<SolutionRequest>() && message.read(request)) solutions.push_back(request);
      robot_.robot().fromTools().append(message);
      if (!asksOnce(message)) robot_.requests_.append(message);
    });
    robot_.toRobot_.clear();
    robot_.robot().answer();
    for (const SolutionRequest& request : solutions) robot_.runsAnother(request);
    for (; caveats_ < robot_.platform_.caveats().size(); ++caveats_)
      answers.write({}, Text{robot_.platform_.caveats()[caveats_], Severity::warning});
    take(answers);
    robot_.handOver(take);
  }
  std::optional<ConstValue> peek(std::string_view representation) const override {
    return robot_.robot().value(representation);
  }

 private:
  LogRobot& robot_;
  std::size_t caveats_ = 0;  ///< That were reported.
};

LogRobot::LogRobot(OpenedLog log)
    : file_{std::move(log.file)},
      converted_{std::move(log.converted)},
      platform_{std::move(log.platform)},
      warnings_{std::move(log.warnings)} {
  platform_.showRecorded();
  platform_.onNewRobot([this](Robot& robot) {
    requests_.copyAllMessages(robot.fromTools());
    robot.answer();
    ++beginnings_;
  });
}

Result<std::unique_ptr<LogRobot>> LogRobot::open(const std::string& file,
                                                 const LogRobotOptions& options) {
  auto log = openLog(file, options);
  if (!log) return log.error();
  return std::unique_ptr<LogRobot>{new LogRobot{std::move(*log)}};
}

std::unique_ptr<RobotLink> LogRobot::link() {
  return std::make_unique<Link>(*this);
}

bool LogRobot::refuses(const Message& message, MessageQueue& answers) const {
  SolutionRequest request;
  if (!message.is<SolutionRequest>() || !message.read(request)) return false;
  const std::string missing = platform_.missingFor(request.task);
  if (missing.empty() || request.solution == SolutionTable::disabled) return false;
  answers.write({}, answerTo(message, "log", Error{.field = request.task, .what = missing}));
  return true;
}

/// A task's other solution runs on what was recorded, if the robot has taken it.
void LogRobot::runsAnother(const SolutionRequest& request) {
  const auto& own = robot().setup().configuration->solutions;
  const bool isRecorded = std::ranges::any_of(own, [&](const auto& choice) {
    return choice.task == request.task && choice.solution == request.solution;
  });
  if (isRecorded || request.solution == SolutionTable::disabled) return;
  for (const auto& process : robot().processes())
    if (process->activeSolution(request.task) == request.solution)
      platform_.runsAnother(request.task);
}

void LogRobot::handOver(const RobotLink::Taker& take) {
  take(robot().toTools());
  robot().toTools().clear();
}

Result<bool> LogRobot::playNext(const RobotLink::Taker& take) {
  auto more = platform_.step();
  handOver(take);
  return more;
}

Result<void> LogRobot::goTo(std::size_t moment, const RobotLink::Taker& take) {
  if (auto done = platform_.goTo(moment); !done) return done;
  handOver(take);
  return {};
}

Result<void> LogRobot::pass(double ms, const RobotLink::Taker& take) {
  player().pass(ms);
  while (player().due()) {
    // At the end of a loop.
    if (player().position() == 0 && platform_.now() > player().begin()) {
      if (auto done = goTo(0, take); !done) return done;
      continue;
    }
    if (const auto more = playNext(take); !more) return more.error();
  }
  return {};
}

Result<void> LogRobot::step(int moments, const RobotLink::Taker& take) {
  for (; moments > 0 && !player().atEnd(); --moments)
    if (const auto more = playNext(take); !more) return more.error();
  if (moments >= 0) return {};
  const auto back = static_cast<std::size_t>(-static_cast<std::int64_t>(moments));
  const std::size_t last = player().position() == 0 ? 0 : player().position() - 1;
  return goTo(last - std::min(back, last), take);
}

Result<void> LogRobot::goToTime(Time time, const RobotLink::Taker& take) {
  player().seekTime(time);
  auto done = goTo(player().position(), take);
  player().waitFrom(time);
  return done;
}

std::optional<Error> LogRobot::takeWarning() {
  if (warnings_.empty()) {
    auto warning = platform_.takeWarning();
    if (warning && converted_) warning->file = file_;
    return warning;
  }
  Error warning = std::move(warnings_.front());
  warnings_.erase(warnings_.begin());
  return warning;
}

Result<void> LogRobot::goToMessage(std::uint64_t message, const RobotLink::Taker& take) {
  player().seekMessage(message);
  return goTo(player().position(), take);
}

}  // namespace gt
