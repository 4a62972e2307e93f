#include "match/ReportImages.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gt {
namespace {

constexpr std::array reportKeys{"ImageProcessor/horizon", "ImageProcessor/percepts"};

}  // namespace

ReportImages::ReportImages(int count, double minutes, const std::vector<SimulatedRobot*>& robots)
    : count_{static_cast<std::size_t>(count)}, duration_{60'000 * minutes}, robots_{robots} {
  if (count == 0) return;
  for (SimulatedRobot* robot : robots_)
    robot->observe([this, robot](const MessageQueue& messages) {
      if (requested_ == robot) take(*robot, messages);
    });
}

void ReportImages::step(Time now) {
  if (!requestedImage_.drawings.empty()) {
    requestedImage_.title = requested_->name() + " at " + clockText(now);
    images_.push_back(std::exchange(requestedImage_, {}));
    requested_ = nullptr;
  }
  const auto due = static_cast<std::size_t>(static_cast<double>(now.ms) / duration_ *
                                            static_cast<double>(count_));
  if (!requested_ && images_.size() < std::min(due, count_) && !robots_.empty())
    request(*robots_[images_.size() * 3 % robots_.size()]);
}

void ReportImages::request(SimulatedRobot& robot) {
  requested_ = &robot;
  for (const char* key : reportKeys)
    if (DebugKey::find(key))
      static_cast<void>(robot.robot().request(DebugRequest{key, DebugKeyMode::times, 1}));
}

void ReportImages::take(const SimulatedRobot& robot, const MessageQueue& messages) {
  if (!requestedImage_.drawings.empty()) return;
  messages.handleAllMessages([&](const Message& message) {
    Drawing drawing;
    if (message.is<Drawing>() && message.read(drawing) && drawing.space == DrawingSpace::image &&
        std::ranges::find(reportKeys, drawing.key) != reportKeys.end())
      requestedImage_.drawings.push_back(std::move(drawing));
  });
  if (!requestedImage_.drawings.empty()) requestedImage_.image = *robot.lastImage();
}

}  // namespace gt
