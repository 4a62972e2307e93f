#include "observer/Recorder.h"

#include <filesystem>
#include <utility>

#include "logs/LogTransfer.h"
#include "logs/RecordedSetup.h"

namespace gt {

Recorder::~Recorder() {
  stop();
}

Result<void> Recorder::open() {
  folder_ = std::make_unique<TemporaryFolder>();
  auto log = RobotLog::open(path(), {{"robot", robot_.name()}});
  if (!log) return log.error();
  log_ = std::move(*log);
  const auto& inputs = robot_.inputs();
  log_->setInputs({inputs.begin(), inputs.end()});
  // A robot that does not provide its setup can be recorded, too.
  if (const auto setup = robot_.setup()) attach(*setup, log_->file());
  return {};
}

Result<void> Recorder::start() {
  if (recording_) return {};
  if (!log_)
    if (auto done = open(); !done) return done;
  for (const std::string& input : robot_.inputs()) inputs_.push_back(robot_.subscribe(input));
  trace(true);
  recording_ = true;
  passing_ = robot_.passTo([this](const MessageQueue& messages) { take(messages); });
  return {};
}

/// What the behavior decides, and why, if the robot has a behavior.
void Recorder::trace(bool on) {
  static_cast<void>(robot_.request(
      DebugRequest{traceKey, on ? DebugKeyMode::always : DebugKeyMode::disabled, 0}));
}

void Recorder::stop() {
  if (!recording_) return;
  recording_ = false;
  passing_.reset();
  trace(false);
  inputs_.clear();
}

void Recorder::clear() {
  const bool on = recording_;
  stop();
  log_.reset();
  messages_ = saved_ = 0;
  file_.clear();
  if (on) static_cast<void>(start());
}

/// Answers concern who asked; an image may be sent again while there is no newer one.
void Recorder::take(const MessageQueue& messages) {
  messages.handleAllMessages([this](const Message& message) {
    if (message.is<RequestAnswer>() || message.is<ProcessDescription>() ||
        message.is<RecordedSetup>())
      return;
    Image image;
    if (message.is<Image>()) {
      if (!message.read(image) || std::exchange(lastImage_, image.time) == image.time) return;
      log_->write(image);
    }
    log_->write(message);
  });
  messages_ = log_->messages();
}

Result<void> Recorder::save(const std::string& file) {
  if (!log_) return Error{.field = robot_.name(), .what = "nothing was recorded; log start begins"};
  static_cast<void>(log_->flush());  // what is missing is counted below
  std::error_code ignored;           // then opening the file reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  const auto copied = repairLog(path(), file);
  if (!copied) return copied.error();
  saved_ = messages_;
  file_ = file;
  if (copied->messages >= messages_) return {};
  return Error{.file = file,
               .what = "holds the first " + std::to_string(copied->messages) + " of " +
                       std::to_string(messages_) +
                       " messages: there was no room for the others while it was recorded"};
}

}  // namespace gt
