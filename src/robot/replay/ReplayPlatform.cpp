#include "robot/replay/ReplayPlatform.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "debug/Drawing.h"
#include "logs/MessageTypes.h"
#include "logs/RobotLog.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/BehaviorTrace.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/motion/OdometryData.h"
#include "robot/SetupFiles.h"
#include "robot/Solutions.h"
#include "robot/replay/LogPlatform.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// How long a robot runs on a log before the moment that is gone to, in ms.
constexpr std::int64_t leadIn = 10'000;

bool provides(const Plan& plan, const RepresentationType& type) {
  return std::ranges::any_of(plan.processes, [&](const Plan::Process& process) {
    return std::ranges::any_of(process.order, [&](const Plan::Step& step) {
      return std::ranges::find(step.task->outputs, &type) != step.task->outputs.end();
    });
  });
}

bool contains(const std::vector<const RepresentationType*>& types, std::string_view name) {
  return std::ranges::find(types, name, &RepresentationType::name) != types.end();
}

/// Whether a solution reads one of these types.
bool reads(const Solution* solution, const std::vector<const RepresentationType*>& types) {
  return solution && std::ranges::any_of(solution->ports, [&](const Port& port) {
           return port.kind != PortKind::output && contains(types, port.type->name);
         });
}

/// An error about a file or folder that a log holds says so: another version reads them.
Error aboutFiles(const Error& error, const RecordedSetup& recorded, const std::string& log) {
  const auto isConcerned = [&](const SetupFile& file) {
    return file.name == error.file || file.name.starts_with(error.file + "/");
  };
  if (std::ranges::none_of(recorded.files, isConcerned)) return error;
  const std::string who = recorded.commit.empty() ? "another one" : "commit " + recorded.commit;
  return {.file = log,
          .what = error.text() + "; this program does not read the files that " + who +
                  " has recorded: give it other ones (gtlog replay --config FOLDER --layout FILE)"};
}

}  // namespace

Result<ReplayPlatform> ReplayPlatform::make(const ReplayOptions& options) {
  auto player = LogPlayer::open(options.log);
  if (!player) return player.error();
  ReplayPlatform platform{std::move(*player)};
  const auto& damage = platform.player_.log().damage();
  platform.warnings_.assign(damage.begin(), damage.end());
  if (auto done = platform.findChannels(); !done) return done.error();
  if (auto done = platform.chooseSetup(options); !done) return done.error();
  platform.dropStandingProcesses();
  platform.disableUnrecorded();
  if (auto done = platform.lookForMemory(); !done) return done.error();
  if (auto done = platform.makeRobot(); !done) return done.error();
  if (platform.robot().processes().empty())
    return platform.damaged(inputTopic, "nothing in the log begins a cycle of a process");
  return platform;
}

Error ReplayPlatform::damaged(std::string field, std::string what) const {
  return {.file = player_.path(), .field = std::move(field), .what = std::move(what)};
}

Result<void> ReplayPlatform::findChannels() {
  constexpr std::string_view inputs = inputTopic;
  bool any = false;
  for (const McapChannel& recorded : player_.log().channels()) {
    channels_.resize(std::max<std::size_t>(channels_.size(), recorded.id + std::size_t{1}));
    const std::string_view topic = recorded.topic;
    const bool input = topic.starts_with(inputs);
    const std::string_view name =
        topic.substr(input ? inputs.size() : std::min<std::size_t>(1, topic.size()));
    const RepresentationType* type =
        name == "ImageHeader" ? &representation<ImageHeader>() : messageType(name);
    if (!type && input)
      warnings_.push_back(damaged(recorded.topic, "is left out: no platform sends this"));
    if (!type) continue;
    std::optional<MessageDefinition> definition;
    if (recorded.schemaText != type->schema().text) {
      auto parsed = MessageDefinition::parse(recorded.schemaName, recorded.schemaText);
      if (!parsed) {
        warnings_.push_back(damaged(recorded.topic, "is left out: " + parsed.error().text()));
        continue;
      }
      definition = std::move(*parsed);
    }
    any |= input;
    channels_[recorded.id].emplace(Channel{type, std::move(definition), type->make(), input});
  }
  pixels_ = isRecorded("Image", true);
  const bool headers = isRecorded("ImageHeader", true);
  // A percept of each image states at least when it was taken.
  for (const std::string& percept : perceptsOfImages(solutions()))
    if (!pixels_ && !headers && perceptOfImages_.empty() && isRecorded(percept, false))
      perceptOfImages_ = percept;
  if (any || !perceptOfImages_.empty()) return {};
  return damaged(inputTopic, "the log does not hold what its robot sensed");
}

bool ReplayPlatform::isRecorded(std::string_view name, bool input) const {
  return std::ranges::any_of(channels_, [&](const auto& channel) {
    return channel && channel->input == input && channel->type->name == name;
  });
}

/// The setup of the log's robot, with what is wanted instead.
Result<void> ReplayPlatform::chooseSetup(const ReplayOptions& options) {
  const bool another = options.configuration && !options.layout.empty();
  if (auto recorded = recordedSetup(player_.log(), player_.path()))
    recorded_ = std::move(*recorded);
  else if (!another)
    return recorded.error();
  if (!another) {
    if (recorded_.files.empty()) return damaged("", "the log does not hold its robot's files");
    auto made = readSetup(recorded_, allModules());
    if (!made) return aboutFiles(made.error(), recorded_, player_.path());
    setup_ = std::move(*made);
  }
  setup_.player = recorded_.player;
  setup_.seed = recorded_.seed;
  setup_.address = recorded_.address;
  if (options.configuration) setup_.configuration = options.configuration;
  otherFiles_ = options.configuration && !recorded_.files.empty();
  if (!options.layout.empty()) {
    auto layout = loadLayout(options.layout);
    if (!layout) return layout.error();
    setup_.layout = std::move(*layout);
  }
  solutions_ = options.solutions;
  wholeRobot_ = options.wholeRobot;
  for (const Configuration::SolutionChoice& choice : options.solutions)
    if (choice.solution != SolutionTable::disabled) chosen_.insert(choice.task);
  // What another layout asks for and was not recorded stays as it is at a robot's start.
  for (const RepresentationType* type : LogPlatform::representations())
    if ((isRecorded(type->name, true) || !options.layout.empty()) &&
        !contains(setup_.platform, type->name))
      setup_.platform.push_back(type);
  // What the log's robot was not told, solutions may be that are chosen for the replay.
  const RepresentationType& truth = representation<OracledWorldState>();
  if (isRecorded(truth.name, false) || isRecorded(truth.name, true))
    setup_.platform.push_back(&truth);
  return {};
}

/// A process whose cycles nothing begins stands: what its tasks would provide comes from the log,
/// as from the platform.
void ReplayPlatform::dropStandingProcesses() {
  const auto begins = [&](const std::string& trigger) {
    if (trigger == "Image")
      return pixels_ || isRecorded("ImageHeader", true) || !perceptOfImages_.empty();
    if (trigger == "SensorDataBuffer")
      return isRecorded("SensorDataBuffer", true) || isRecorded("SensorData", true);
    return !contains(setup_.platform, trigger) || isRecorded(trigger, true) ||
           isRecorded(trigger, false);
  };
  std::erase_if(setup_.layout.processes, [&](const ProcessLayout& process) {
    if (process.collectsMessages || begins(process.trigger)) return false;
    for (const ProcessLayout::Group& group : process.groups)
      for (const std::string& name : group.tasks)
        if (const Task* task = solutions().find(name))
          for (const RepresentationType* output : task->outputs)
            if (!contains(setup_.platform, output->name)) setup_.platform.push_back(output);
    return true;
  });
  // Only what the other processes solve is configured.
  auto part = std::make_shared<Configuration>(*setup_.configuration);
  std::erase_if(part->solutions, [&](const auto& choice) {
    return std::ranges::none_of(setup_.layout.processes, [&](const ProcessLayout& process) {
      return std::ranges::any_of(process.groups, [&](const auto& group) {
        return std::ranges::find(group.tasks, choice.task) != group.tasks.end();
      });
    });
  });
  setup_.configuration = std::move(part);
}

std::string ReplayPlatform::missingFor(std::string_view task) const {
  if (task == imageTask && !pixels_)
    return "the log does not hold the images' pixels (simgt play --inputs records them)";
  return {};
}

/// Disables what cannot be computed on this log, or was not on the robot that recorded it.
void ReplayPlatform::disableUnrecorded() {
  for (const ProcessLayout& process : setup_.layout.processes)
    for (const ProcessLayout::Group& group : process.groups)
      for (const std::string& name : group.tasks) {
        const Task* task = solutions().find(name);
        const bool given =
            task && std::ranges::any_of(task->outputs, [&](const RepresentationType* output) {
              return isRecorded(output->name, true);
            });
        if (given || !missingFor(name).empty())
          solutions_.insert(solutions_.begin(),
                            {name, std::string{SolutionTable::disabled}, "", 0});
      }
}

/// Modules remember what came before the log's begin, unless their robot began with the log: then
/// its first frames of sensor data have no past. A robot's program that records itself reports so.
Result<void> ReplayPlatform::lookForMemory() {
  if (!isRecorded("SensorData", true) && !isRecorded("SensorDataBuffer", true)) return {};
  const auto& all = player_.log().metadata();
  const bool withProgram = std::ranges::any_of(all, [](const McapReader::Metadata& metadata) {
    return metadata.entries.contains(beginsWithProgram);
  });
  for (bool found = false; !found && !player_.atEnd();) {
    const auto more = player_.next([&](const McapChannel& recorded, const McapMessage& message) {
      auto& channel = channels_[recorded.id];
      if (found || !channel || !channel->input) return Result<void>{};
      const bool whole = channel->type == &representation<SensorDataBuffer>();
      if (!whole && channel->type != &representation<SensorData>()) return Result<void>{};
      found = true;
      if (!decode(*channel, message)) return Result<void>{};
      const auto* buffer = static_cast<const SensorDataBuffer*>(channel->value.get());
      if (!whole || (!withProgram && buffer->frames.front().time != buffer->newest().time))
        caveats_.push_back(
            "the log begins in mid-run, and does not hold what the modules remembered then");
      return Result<void>{};
    });
    if (!more) return more.error();
  }
  player_.seek(0);
  return {};
}

Result<void> ReplayPlatform::makeRobot() {
  auto robot = Robot::make(setup_);
  const bool ofLog = !std::filesystem::exists(setup_.configuration->files.paths.config);
  if (!robot && ofLog) return aboutFiles(robot.error(), recorded_, player_.path());
  if (!robot) return robot.error();
  robot_ = std::move(*robot);
  if (!recorded_.files.empty())
    robot_->provideSetup([setup = recorded_]() -> Result<RecordedSetup> { return setup; });
  for (auto& channel : channels_)
    if (channel) {
      channel->provided = provides(robot_->plan(), *channel->type);
      // What was recorded both as the platform sent it and as the robot had it is sent once.
      channel->sent =
          channel->input || (!channel->provided && !isRecorded(channel->type->name, true) &&
                             contains(setup_.platform, channel->type->name));
    }
  for (const Configuration::SolutionChoice& choice : solutions_) {
    if (const std::string missing = missingFor(choice.task);
        !missing.empty() && choice.solution != SolutionTable::disabled)
      return damaged(choice.task, missing);
    if (auto done = robot_->request(SolutionRequest{choice.task, choice.solution}); !done)
      return done;
  }
  takeDecisions();
  return {};
}

void ReplayPlatform::runsAnother(const std::string& task) {
  chosen_.insert(task);
  takeDecisions();
}

/// Disables a task that was not chosen, so that the log stands for it; `gaps` gets those of its
/// outputs that the log does not hold. Returns false if it was disabled already.
bool ReplayPlatform::disableFor(const Task& task, std::vector<const RepresentationType*>& gaps) {
  if (chosen_.contains(task.name) || robot_->isDisabled(*task.outputs.front())) return false;
  static_cast<void>(
      robot_->request(SolutionRequest{task.name, std::string{SolutionTable::disabled}}));
  for (const RepresentationType* output : task.outputs)
    if (!isRecorded(output->name, false)) gaps.push_back(output);
  return true;
}

/// Has the log stand for what the robot decided, and for what was made of decisions that were not
/// recorded, as far as that was.
void ReplayPlatform::takeDecisions() {
  if ((chosen_.empty() && !otherFiles_) || wholeRobot_) return;
  std::vector<const Task*> tasks;
  for (const Plan::Process& process : robot_->plan().processes)
    for (const Plan::Step& step : process.order) tasks.push_back(step.task);
  const auto caveat = [this](std::string text) {
    if (std::ranges::find(caveats_, text) == caveats_.end()) caveats_.push_back(std::move(text));
  };
  const auto active = [this](const Task& task) -> const Solution* {
    for (const auto& process : robot_->processes())
      if (process->solves(task.name)) return task.find(process->activeSolution(task.name));
    return nullptr;
  };
  const auto provider = [&](std::string_view type) {
    const auto task = std::ranges::find_if(
        tasks, [&](const Task* other) { return contains(other->outputs, type); });
    return task == tasks.end() ? nullptr : *task;
  };
  const Task* motion = provider(representation<OdometryData>().name);
  for (const Task* task : tasks)
    if (motion && chosen_.contains(task->name) &&
        (task == motion || reads(active(*motion), task->outputs)))
      caveat(task->name + " moves the robot, but its recorded body did not move so");
  std::vector<const RepresentationType*> gaps;
  const std::string_view decision = representation<MotionRequest>().name;
  if (const Task* decides = provider(decision); decides && isRecorded(decision, false))
    disableFor(*decides, gaps);
  else if (decides && motion)
    caveat("the log does not hold what its robot decided, " + std::string{decision} +
           ": OdometryData is computed anew, and may differ from what its body did");
  const auto standsFor = [this](const Task& task) {
    return std::ranges::any_of(task.outputs, [this](const RepresentationType* output) {
      return isRecorded(output->name, false);
    });
  };
  for (bool more = true; std::exchange(more, false);)
    for (const Task* task : tasks)
      if (standsFor(*task) && reads(active(*task), gaps)) more |= disableFor(*task, gaps);
}

void ReplayPlatform::watchAll() {
  const auto watch = [this](const std::string& name) {
    const auto type = robot_->watch(name);
    if (type && (*type)->type() && std::ranges::find(watched_, *type) == watched_.end())
      watched_.push_back(*type);
  };
  for (const auto& channel : channels_)
    if (channel && !channel->input) watch(std::string{channel->type->name});
  for (const Plan::Process& process : robot_->plan().processes)
    for (const Plan::Step& step : process.order)
      for (const RepresentationType* output : step.task->outputs) watch(std::string{output->name});
}

std::optional<Error> ReplayPlatform::takeWarning() {
  if (warnings_.empty()) return std::nullopt;
  Error warning = std::move(warnings_.front());
  warnings_.pop_front();
  return warning;
}

/// False for a message that cannot be read; the first one of a channel is reported.
bool ReplayPlatform::decode(Channel& channel, const McapMessage& message) {
  const auto done = channel.definition
                        ? readRecorded(*channel.definition, message.data,
                                       Value{channel.type->type(), channel.value.get()})
                        : channel.type->decode(message.data, channel.value.get());
  if (!done && !std::exchange(channel.unreadable, true))
    warnings_.push_back(damaged(std::string{channel.type->name},
                                "messages are left out, the first at " + timeText(message.time) +
                                    ": " + done.error().text()));
  return static_cast<bool>(done);
}

void ReplayPlatform::send(const RepresentationType& type, const void* package) {
  robot_->send(type, package);
  if (input_) input_(now_, type, package);
}

/// What was recorded in short is sent whole.
void ReplayPlatform::send(const Channel& channel) {
  const void* value = channel.value.get();
  if (channel.type == &representation<SensorDataBuffer>()) {
    sensors_ = *static_cast<const SensorDataBuffer*>(value);
    send(representation<SensorDataBuffer>(), &sensors_);
  } else if (channel.type == &representation<SensorData>()) {
    sensors_.push(*static_cast<const SensorData*>(value));
    send(representation<SensorDataBuffer>(), &sensors_);
  } else if (channel.type == &representation<ImageHeader>()) {
    const auto& header = *static_cast<const ImageHeader*>(value);
    image_.time = header.time;
    image_.info = header.info;
    sendImage();
  } else {
    send(*channel.type, value);
  }
}

void ReplayPlatform::sendImage() {
  image_.allocate();
  send(representation<Image>(), &image_);
}

Result<void> ReplayPlatform::take(const McapChannel& recorded, const McapMessage& message) {
  auto& channel = channels_[recorded.id];
  if (!channel) return {};
  if (channel->type->name == perceptOfImages_) {
    image_.time = now_;
    sendImage();
  }
  if (channel->sent) {
    if (!decode(*channel, message)) return {};
    send(*channel);
  } else if (!channel->provided) {
    if (!showsRecorded_) return {};
    if (!decode(*channel, message)) return {};
    show(*channel);
  } else if (robot_->isDisabled(*channel->type)) {
    if (!decode(*channel, message)) return {};
    robot_->layIfDisabled(*channel->type, channel->value.get());
  }
  return {};
}

/// What was sent under a debug key that is off: the robot does not send it.
void ReplayPlatform::show(const Channel& channel) {
  std::string_view key;
  if (channel.type == &representation<Drawing>())
    key = static_cast<const Drawing*>(channel.value.get())->key;
  else if (channel.type == &representation<Plot>())
    key = static_cast<const Plot*>(channel.value.get())->key;
  else if (channel.type == &representation<BehaviorState>())
    key = "BehaviorControl/activations";
  else if (channel.type == &representation<BehaviorTrace>())
    key = traceKey;
  const DebugKey* known = DebugKey::find(key);
  if (!known || std::ranges::any_of(robot_->processes(), [&](const auto& process) {
        return process->debug().keys().get(*known).mode != DebugKeyMode::disabled;
      }))
    return;
  channel.type->write(channel.value.get(), now_, robot_->toTools());
}

Result<bool> ReplayPlatform::step() {
  if (player_.atEnd()) return false;
  now_ = player_.moments()[player_.position()].time;
  const auto more = player_.next([this](const McapChannel& channel, const McapMessage& message) {
    return take(channel, message);
  });
  if (!more || !*more) return more;
  robot_->step(now_);
  return true;
}

Result<void> ReplayPlatform::goTo(std::size_t moment) {
  if (auto done = makeRobot(); !done) return done;
  if (newRobot_) newRobot_(*robot_);
  const std::size_t last = std::min(moment, player_.moments().size() - 1);
  player_.seekTime(player_.moments()[last].time - leadIn);
  while (player_.position() <= last) {
    robot_->toTools().clear();
    if (const auto more = step(); !more) return more.error();
  }
  player_.seek(last + 1);
  return {};
}

}  // namespace gt
