#include "match/LockstepRobot.h"

#include <tuple>
#include <utility>

namespace gt {

LockstepRobot::LockstepRobot(std::string name, FileDescriptor socket,
                             std::chrono::milliseconds patience,
                             std::optional<ConnectedProgram> program)
    : name_{std::move(name)},
      program_{std::move(program)},
      stream_{std::move(socket), lockstepVocabulary(), lockstepQueueSize, patience} {}

Result<std::unique_ptr<LockstepRobot>> LockstepRobot::start(std::string name,
                                                            const std::vector<std::string>& command,
                                                            std::chrono::milliseconds patience) {
  auto program = ConnectedProgram::start(command);
  if (!program) return program.error();
  FileDescriptor socket = program->takeSocket();
  return std::make_unique<LockstepRobot>(std::move(name), std::move(socket), patience,
                                         std::move(*program));
}

/// The error with the robot's name.
Error LockstepRobot::named(Error error) {
  error.field = name_ + (error.field.empty() ? "" : ": " + error.field);
  return error;
}

Result<void> LockstepRobot::receive() {
  const auto came = stream_.receive(messages_);
  if (!came) return Error{.what = "its program " + came.error().text()};
  if (!*came) return Error{.what = "its program " + (program_ ? program_->ending() : "has ended")};
  return {};
}

Result<void> LockstepRobot::greet() {
  if (auto done = receive(); !done) return named(done.error());
  std::optional<Error> failure;
  Result<void> done;
  messages_.handleAllMessages([&](const Message& message) {
    Result<void> read;
    if (message.is<LockstepGreeting>()) read = message.read(greeting_);
    if (message.is<CameraSettings>()) read = message.read(commands_.camera);
    if (LockstepFailure told; message.is<LockstepFailure>() && (read = message.read(told)))
      failure = Error{.file = told.file,
                      .line = told.line,
                      .column = told.column,
                      .field = told.element,
                      .what = told.what};
    if (!read) done = read;
  });
  if (failure) return *failure;
  if (!done) return named(done.error());
  if (greeting_.protocol != lockstepProtocol)
    return named({.what = "its program of commit '" + greeting_.commit +
                          "' takes turns by protocol " + std::to_string(greeting_.protocol) +
                          "; this one by " + std::to_string(lockstepProtocol)});
  done = stream_.introduce(MessageQueue{0});
  return done ? done : named(done.error());
}

void LockstepRobot::cycle(const RobotInput& input, RobotOutput&) {
  if (failure_) return;
  withImage_ = input.image != nullptr;
  if (auto done = send(input); !done) failure_ = named(done.error());
}

void LockstepRobot::finish(RobotOutput& output) {
  if (failure_) return;
  auto done = receive();
  if (done) done = takeAnswer();
  if (done)
    commands_.give(output, belief_, withImage_);
  else
    failure_ = named(done.error());
}

Result<void> LockstepRobot::send(const RobotInput& input) {
  messages_.clear();
  input.forEach([&](const auto& package) { messages_.write(input.now, package); });
  if (messages_.dropped() > 0) return Error{.what = "its image is too large"};
  // If the program has ended, its end says why.
  static_cast<void>(stream_.send(messages_));
  return {};
}

/// The slot for values of type T.
template <typename Slots, typename T>
auto& LockstepRobot::slot(Slots& slots, const T*) {
  return std::get<Received<T>>(slots);
}

template <typename T>
Result<void> LockstepRobot::Received<T>::take(const Message& message, const T*& place) {
  if (!message.is<T>()) return {};
  if (auto done = message.read(value); !done) return done;
  if (!isSane(value))
    return Error{.field = std::string{representation<T>().name},
                 .what = "its program commands what no body can do"};
  place = &value;
  return {};
}

Result<void> LockstepRobot::takeAnswer() {
  Result<void> done;
  messages_.handleAllMessages([&](const Message& message) {
    const auto take = [&]<typename T>(Received<T>& received, const T*& place) {
      if (auto taken = received.take(message, place); !taken) done = taken;
    };
    std::apply([&](auto&... places) { (take(slot(received_, places), places), ...); },
               commands_.places);
    belief_.forEach([&](auto& part) { take(slot(believed_, part), part); });
  });
  if (!done) return done;
  if (!commands_.place<JointData>()) return Error{.what = "its program commands no joints"};
  return {};
}

}  // namespace gt
