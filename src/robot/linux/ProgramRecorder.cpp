#include "robot/linux/ProgramRecorder.h"

#include <set>
#include <string>

#include "framework/Requests.h"
#include "network/Wire.h"
#include "robot/SetupFiles.h"

namespace gt {

Result<std::unique_ptr<ProgramRecorder>> ProgramRecorder::open(const RobotProgramOptions& options,
                                                               const Layout& layout,
                                                               const RobotModules& modules) {
  const std::vector<const RepresentationType*> none;
  const auto configuration = loadConfiguration(options.paths, modules, &none);
  if (!configuration) return configuration.error();
  auto log = RobotLog::open(freeLogFile(options.logs + "/" + options.addresses.robot),
                            {{"robot", options.addresses.robot}});
  if (!log) return log.error();
  const auto setup = recordSetup(
      {options.paths, options.layout, options.player, options.seed, options.hardwareAddress});
  if (!setup) return setup.error();
  attach(*setup, log->file());
  std::unique_ptr<ProgramRecorder> recorder{new ProgramRecorder{std::move(*log), layout}};
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
  log_.flush();
  nextFlush_ = now + 1000;
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
