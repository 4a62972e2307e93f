#include "robot/linux/Recorder.h"

#include <algorithm>

#include "framework/Requests.h"
#include "network/Wire.h"
#include "robot/RecordedSetup.h"

namespace gt {

Result<std::unique_ptr<Recorder>> Recorder::open(const RobotProgramOptions& options,
                                                 const Layout& layout,
                                                 const RobotModules& modules) {
  const std::vector<const RepresentationType*> none;
  const auto configuration = loadConfiguration(options.paths, modules, &none);
  if (!configuration) return configuration.error();
  auto log = RobotLog::open(freeLogFile(options.logs + "/" + options.addresses.robot),
                            {{"robot", options.addresses.robot}});
  if (!log) return log.error();
  const RecordedSetup setup{options.paths, options.layout, options.player, options.seed,
                            options.hardwareAddress};
  if (auto done = attachSetup(setup, log->file()); !done) return done.error();
  std::unique_ptr<Recorder> recorder{new Recorder{std::move(*log), layout}};
  recorder->choose((*configuration)->log, modules.solutions);
  return recorder;
}

/// What no task provides comes from the platform.
void Recorder::choose(const Configuration::LogSettings& settings, const SolutionTable& table) {
  for (const auto& [name, task] : table.tasks())
    for (const RepresentationType* type : task.outputs) log_.know(*type);
  for (const std::string& name : settings.representations) {
    const auto& inputs = platformRepresentations();
    const auto input = std::ranges::find(inputs, name, &RepresentationType::name);
    if (input == inputs.end()) {
      requests_.push_back({name, ""});
    } else {
      log_.know(**input);
      inputs_.push_back(std::make_unique<Input>(**input));
    }
  }
  picturePeriod_ = settings.picturePeriod;
}

void Recorder::connect(Wire& wire) {
  if (picturePeriod_ > 0) wire.receive(platformProcess, pictures_);
  for (const auto& input : inputs_) wire.receive(platformProcess, input->receiver);
}

void Recorder::ask(const Wire& wire, MessageQueue& requests) {
  for (const ProcessLayout& process : layout_.processes) {
    std::uint64_t& known = sessions_[process.name];
    const std::uint64_t session = wire.clockOf(process.name).session;
    if (session == known) continue;
    known = session;
    for (const WatchRequest& request : requests_) requests.write({}, request);
  }
}

void Recorder::write(const Wire& wire, const MessageQueue& messages, std::int64_t now) {
  log_.write(messages);
  for (const auto& input : inputs_) {
    input->receiver.receive();
    if (input->receiver.receivedNew())
      input->type.write(input->value.get(), wire.clockOf(platformProcess).time, fromPlatform_);
    input->receiver.request();
  }
  log_.write(fromPlatform_);
  fromPlatform_.clear();
  if (picturePeriod_ > 0) writePicture(now);
  if (now < nextFlush_) return;
  log_.flush();
  nextFlush_ = now + 1000;
}

/// The platform is asked for the next picture only when it is due; its clock, which begins anew
/// when it is started again, may be slower than that of this process.
void Recorder::writePicture(std::int64_t now) {
  pictures_.receive();
  const bool isDue = picture_.time < lastPicture_ || picture_.time - lastPicture_ >= picturePeriod_;
  if (pictures_.receivedNew() && isDue) {
    log_.write(picture_);
    lastPicture_ = picture_.time;
    nextRequest_ = now + picturePeriod_;
  }
  if (now >= nextRequest_) pictures_.request();
}

}  // namespace gt
