#include "robot/linux/ProgramRecorder.h"

#include <filesystem>
#include <set>
#include <string>

#include "framework/Requests.h"
#include "network/Wire.h"
#include "robot/SetupFiles.h"
#include "robot/replay/ReplayPlatform.h"

namespace gt {
namespace {

/// Begins a log that is not there yet; none is left behind if it cannot be written.
Result<RobotLog> beginLog(const RobotProgramOptions& options, const RecordedSetup& setup,
                          bool withProgram) {
  const std::string file = freeLogFile(options.logs + "/" + options.addresses.robot);
  McapWriter::Metadata about{{"robot", options.addresses.robot}};
  if (withProgram) about.emplace(beginsWithProgram, "the robot's program");
  auto log = RobotLog::open(file, about);
  if (!log) return log.error();
  attach(setup, log->file());
  if (const auto done = log->flush(); !done) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return done.error();
  }
  return log;
}

}  // namespace

Result<std::unique_ptr<ProgramRecorder>> ProgramRecorder::open(const RobotProgramOptions& options,
                                                               const Layout& layout,
                                                               const RobotModules& modules) {
  const std::vector<const RepresentationType*> none;
  const auto configuration = loadConfiguration(options.paths, modules, &none);
  if (!configuration) return configuration.error();
  const auto setup = recordSetup(
      {options.paths, options.layout, options.player, options.seed, options.hardwareAddress});
  if (!setup) return setup.error();
  auto log = beginLog(options, *setup, true);
  if (!log) return log.error();
  std::unique_ptr<ProgramRecorder> recorder{
      new ProgramRecorder{std::move(*log), options, *setup, layout}};
  recorder->choose((*configuration)->log, modules.solutions);
  return recorder;
}

/// All that the platform sends but whole images, and what was seen in these: so the log can be
/// replayed.
void ProgramRecorder::choose(const Configuration::LogSettings& settings,
                             const SolutionTable& table) {
  std::set<std::string> names{settings.representations.begin(), settings.representations.end()};
  for (const std::string& name : perceptsOfImages(table)) names.insert(name);
  for (const RepresentationType* input : platformRepresentations()) {
    names.erase(std::string{input->name});
    if (input != &representation<Image>()) inputs_.push_back(std::make_unique<Input>(*input));
  }
  for (const std::string& name : names) requests_.push_back({name, ""});
  imagePeriod_ = settings.imagePeriod;
}

void ProgramRecorder::connect(Wire& wire) {
  if (imagePeriod_ > 0) wire.receive(platformProcess, pictures_);
  for (const auto& input : inputs_) wire.receive(platformProcess, input->receiver);
}

void ProgramRecorder::ask(const Wire& wire, MessageQueue& requests) {
  for (const ProcessLayout& process : layout_.processes) {
    std::uint64_t& known = sessions_[process.name];
    const std::uint64_t session = wire.clockOf(process.name).session;
    if (session == known) continue;
    known = session;
    for (const WatchRequest& request : requests_) requests.write({}, request);
    requests.write({}, DebugRequest{traceKey, DebugKeyMode::always, 0});
  }
}

void ProgramRecorder::write(const Wire& wire, const MessageQueue& messages, std::int64_t now) {
  log_.write(messages);
  for (const auto& input : inputs_) {
    input->receiver.receive();
    if (input->receiver.receivedNew())
      log_.writeInput(wire.clockOf(platformProcess).time, input->type, input->value.get());
    input->receiver.request();
  }
  if (imagePeriod_ > 0) writePicture(now);
  if (now < nextFlush_) return;
  if (const auto done = log_.flush(); !done) beginAnew(done.error());
  nextFlush_ = now + 1000;
}

void ProgramRecorder::beginAnew(const Error& reason) {
  if (!std::exchange(broken_, true)) news_.push_back(reason.text());
  auto log = beginLog(options_, setup_, false);
  if (!log) return;
  log_ = std::move(*log);
  broken_ = false;
  news_.push_back("the log goes on in another file");
}

/// The platform is asked for the next image only when it is due; its clock, which begins anew
/// when it is started again, may be slower than that of this process.
void ProgramRecorder::writePicture(std::int64_t now) {
  pictures_.receive();
  const bool isDue = picture_.time < lastPicture_ || picture_.time - lastPicture_ >= imagePeriod_;
  if (pictures_.receivedNew() && isDue) {
    log_.write(picture_);
    lastPicture_ = picture_.time;
    nextRequest_ = now + imagePeriod_;
  }
  if (now >= nextRequest_) pictures_.request();
}

}  // namespace gt
