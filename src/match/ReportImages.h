#pragma once
#include <string>
#include <vector>

#include "match/SimulatedRobot.h"

namespace gt {

/// A camera image with the drawings of the robot's percepts.
struct ReportImage {
  std::string title;
  Image image;
  std::vector<Drawing> drawings;
};

/// Keeps a number of the robots' camera images with their percepts for the report page, spread
/// evenly over a match and over the robots: when the next image is due, the next robot is requested
/// to draw its percepts, and its next image is kept with these drawings. Drawings that were
/// requested by others, or at other times, are not kept.
class ReportImages {
 public:
  /// `count` images in `minutes`. The robots must outlive this object.
  ReportImages(int count, double minutes, const std::vector<SimulatedRobot*>& robots);

  /// Called between two ticks.
  void step(Time now);
  const std::vector<ReportImage>& all() const { return images_; }

 private:
  void request(SimulatedRobot& robot);
  /// Takes the drawings. Runs in the thread of the robot's cycle.
  void take(const SimulatedRobot& robot, const MessageQueue& messages);

  std::size_t count_;
  double duration_;  ///< ms
  std::vector<SimulatedRobot*> robots_;
  const SimulatedRobot* requested_ = nullptr;  ///< The robot whose next image is kept.
  ReportImage requestedImage_;
  std::vector<ReportImage> images_;
};

}  // namespace gt
