#include "robot/logs/ReplayPlatform.h"

#include <algorithm>

#include "robot/RecordedSetup.h"
#include "robot/Solutions.h"
#include "robot/logs/LogPlatform.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// All that a platform may send: a simulator's, and a real robot's log.
const RepresentationType* inputType(std::string_view name) {
  for (const auto* list : {&platformRepresentations(), &LogPlatform::representations()})
    for (const RepresentationType* type : *list)
      if (type->name == name) return type;
  return nullptr;
}

}  // namespace

Result<ReplayPlatform> ReplayPlatform::make(const ReplayOptions& options) {
  auto log = McapReader::open(options.log);
  if (!log) return log.error();
  ReplayPlatform platform{options.log, std::move(*log)};
  if (auto done = platform.findInputs(); !done) return done.error();
  if (auto done = platform.makeRobot(options); !done) return done.error();
  platform.watchAll();
  return platform;
}

Result<void> ReplayPlatform::findInputs() {
  bool any = false;
  for (const McapChannel& channel : log_.channels()) {
    inputs_.resize(std::max<std::size_t>(inputs_.size(), channel.id + std::size_t{1}));
    const std::string_view topic = channel.topic;
    if (!topic.starts_with(inputTopic)) continue;
    const auto* type = inputType(topic.substr(std::string_view{inputTopic}.size()));
    if (!type) return Error{path_, 0, channel.topic, "no platform sends this"};
    Input& input = inputs_[channel.id].emplace(Input{type, std::nullopt, type->make()});
    any = true;
    if (channel.schemaText == type->schema().text) continue;
    auto definition = MessageDefinition::parse(channel.schemaName, channel.schemaText);
    if (!definition) return Error{path_, 0, channel.topic, definition.error().text()};
    input.definition = std::move(*definition);
  }
  if (any) return {};
  return Error{path_, 0, inputTopic, "the log does not hold what its robot sensed"};
}

Result<void> ReplayPlatform::makeRobot(const ReplayOptions& options) {
  RobotSetup setup;
  if (!options.configuration || options.layout.empty()) {
    auto recorded = readSetup(log_, path_, allModules());
    if (!recorded) return recorded.error();
    setup = std::move(*recorded);
  }
  if (options.configuration) setup.configuration = options.configuration;
  if (!options.layout.empty()) {
    auto layout = loadLayout(options.layout);
    if (!layout) return layout.error();
    setup.layout = std::move(*layout);
  }
  setup.platform.clear();
  for (const auto& input : inputs_)
    if (input) setup.platform.push_back(input->type);
  // What another layout asks for and was not recorded stays as it is at a robot's start.
  if (!options.layout.empty())
    for (const RepresentationType* type : LogPlatform::representations())
      if (std::ranges::find(setup.platform, type) == setup.platform.end())
        setup.platform.push_back(type);
  auto robot = Robot::make(setup);
  if (!robot) return robot.error();
  robot_ = std::move(*robot);
  for (const Configuration::SolutionChoice& choice : options.solutions)
    if (auto done = robot_->request(SolutionRequest{choice.task, choice.solution}); !done)
      return done;
  return {};
}

void ReplayPlatform::watchAll() {
  const auto watch = [this](const std::string& name) {
    const auto type = robot_->watch(name);
    if (type && (*type)->type() && std::ranges::find(watched_, *type) == watched_.end())
      watched_.push_back(*type);
  };
  for (const McapChannel& channel : log_.channels())
    if (!inputs_[channel.id] && channel.topic.size() > 1) watch(channel.topic.substr(1));
  for (const Plan::Process& process : robot_->plan().processes)
    for (const Plan::Step& step : process.order)
      for (const RepresentationType* output : step.task->outputs) watch(std::string{output->name});
}

Result<void> ReplayPlatform::send(const McapMessage& message) {
  Input& input = *inputs_[message.channel];
  const auto done = input.definition ? readRecorded(*input.definition, message.data,
                                                    Value{input.type->type(), input.value.get()})
                                     : input.type->decode(message.data, input.value.get());
  if (!done) return Error{path_, 0, std::string{input.type->name}, done.error().text()};
  robot_->send(*input.type, input.value.get());
  return {};
}

Result<bool> ReplayPlatform::step() {
  bool any = false;
  for (;;) {
    if (!message_) {
      auto next = log_.next();
      if (!next) return next.error();
      message_ = *next;
      if (!message_) break;
    }
    if (inputs_[message_->channel]) {
      const Time time{message_->time / 1'000'000};
      if (any && time.ms != now_.ms) break;
      now_ = time;
      any = true;
      if (auto done = send(*message_); !done) return done.error();
    }
    message_.reset();
  }
  if (any) robot_->step(now_);
  return any;
}

}  // namespace gt
