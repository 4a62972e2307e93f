#include "robot/linux/Lockstep.h"

#include <tuple>
#include <type_traits>
#include <utility>

#include "representations/motion/MotionNet.h"
#include "robot/Robot.h"
#include "robot/SetupFiles.h"
#include "robot/platform/Body.h"

namespace gt {
namespace {

Result<std::unique_ptr<Robot>> makeRobot(const RobotProgramOptions& options,
                                         const RobotModules& modules) {
  const auto layout = loadLayout(options.layout);
  if (!layout) return layout.error();
  const auto configuration = loadConfiguration(options.paths, modules);
  if (!configuration) return configuration.error();
  return Robot::make({*configuration, *layout, options.player, options.seed,
                      platformRepresentations(), options.hardwareAddress},
                     modules);
}

LockstepGreeting greetingOf(const Robot& robot) {
  const auto* net = robot.setup().configuration->find<MotionNet>();
  return {lockstepProtocol, commit(), net ? kickNames(*net) : std::vector<std::string>{}};
}

/// Hands a package to the processes, where it can be read to at once, without a copy.
template <typename T>
Result<void> take(const Message& message, Robot& robot, T& room) {
  if (!message.is<T>()) return {};
  T* const place = robot.place<T>();
  T& value = place ? *place : room;
  auto done = message.read(value);
  if (done) robot.send(std::as_const(value));
  return done;
}

template <typename T>
void write(const Robot& robot, Time now, MessageQueue& messages) {
  if (const T* value = robot.provided<T>()) messages.write(now, *value);
}

/// Visits the types of what a robot answers: its commands and what it believes.
template <typename Visit>
void forEachAnswer(const Visit& visit) {
  const auto all = [&](const auto&... types) { (visit(types), ...); };
  std::apply(all, CommandSlots<std::type_identity>{});
  std::apply(all, BeliefSlots<std::type_identity>{});
}

void writeAnswer(const Robot& robot, Time now, MessageQueue& messages) {
  messages.clear();
  forEachAnswer([&]<typename T>(std::type_identity<T>) { write<T>(robot, now, messages); });
}

template <typename T>
using Value = T;

Result<void> takeTurns(Robot& robot, QueueStream& simulator, MessageQueue& messages) {
  InputSlots<Value> rooms;
  while (true) {
    const auto came = simulator.receive(messages);
    if (!came) return came.error();
    if (!*came) return {};
    if (messages.empty()) continue;  // the schemas alone
    Time now;
    Result<void> done;
    messages.handleAllMessages([&](const Message& message) {
      now = message.time;
      std::apply(
          [&](auto&... room) {
            for (const auto& taken : {take(message, robot, room)...})
              if (!taken) done = taken;
          },
          rooms);
    });
    if (!done) return done;
    robot.step(now);
    robot.toTools().clear();
    writeAnswer(robot, now, messages);
    static_cast<void>(simulator.send(messages));
  }
}

}  // namespace

std::vector<std::string> kickNames(const MotionNet& net) {
  std::vector<std::string> kicks;
  for (const MotionNet::Motion& motion : net.motions)
    if (motion.isKick()) kicks.push_back(motion.name);
  return kicks;
}

const Vocabulary& lockstepVocabulary() {
  static const Vocabulary vocabulary = [] {
    std::vector<const RepresentationType*> types = platformRepresentations();
    forEachAnswer(
        [&]<typename T>(std::type_identity<T>) { types.push_back(&representation<T>()); });
    types.push_back(&representation<LockstepGreeting>());
    types.push_back(&representation<LockstepFailure>());
    return Vocabulary{types};
  }();
  return vocabulary;
}

Result<void> runInLockstep(const RobotProgramOptions& options, const RobotModules& modules,
                           FileDescriptor socket) {
  QueueStream simulator{std::move(socket), lockstepVocabulary(), lockstepQueueSize};
  MessageQueue messages{lockstepQueueSize};
  const auto robot = makeRobot(options, modules);
  // Who cannot be sent anything has ended, which is noticed when nothing more comes.
  if (!robot) {
    const Error& error = robot.error();
    messages.write(Time{}, LockstepFailure{.file = error.file,
                                           .line = error.line,
                                           .column = error.column,
                                           .element = error.field,
                                           .what = error.what});
    static_cast<void>(simulator.introduce(messages));
    return {};
  }
  messages.write(Time{}, greetingOf(**robot));
  write<CameraSettings>(**robot, Time{}, messages);
  static_cast<void>(simulator.introduce(messages));
  return takeTurns(**robot, simulator, messages);
}

}  // namespace gt
