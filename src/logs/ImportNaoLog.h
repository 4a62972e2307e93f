#pragma once
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Converts a real robot's log of 2009 (logs/NaoLog.h) to a log of this system: /input/Image as
/// unpacked and /camera as JPEG, /input/CameraMatrix, /input/OdometryData, with /NaoMotionFrame
/// between them. Returns errors for unreadable parts that were skipped.
Result<std::vector<Error>> importNaoLog(const std::string& from, const std::string& to);

}  // namespace gt
