#pragma once
#include <functional>
#include <string>
#include <vector>

#include "labels/LabelErrors.h"
#include "session/ComparedRuns.h"

namespace gt {

/// An image of a log.
struct LoggedImage {
  Time played;             ///< Its time in the log.
  Time taken;              ///< When it was taken, which is the time of its label.
  std::size_t moment = 0;  ///< Index of its moment in the log player.
};

/// The images of a log of this system, in their order: an image's number is its index. Empty if the
/// log does not hold images' pixels.
Result<std::vector<LoggedImage>> imagesOf(const std::string& log,
                                          const std::function<bool(double share)>& progress);

/// Replays a log, optionally with another solution, and compares the percepts in its labeled images
/// with the labels. Any thread may call it.
Result<std::vector<LabelError>> compareWithLabels(
    const ComparedRun& run, const ImageLabels& labels, const LogRobotOptions& options,
    const std::function<bool(double share)>& progress);

}  // namespace gt
