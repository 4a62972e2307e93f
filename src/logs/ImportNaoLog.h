#pragma once
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Writes a real robot's log of 2009 (logs/NaoLog.h) as a log of ours: /input/Image
/// as it was unpacked and /camera as JPEG, /input/CameraMatrix, /input/OdometryData, and
/// /NaoMotionFrame between them. Returns what cannot be read and was left out.
Result<std::vector<Error>> importNaoLog(const std::string& from, const std::string& to);

}  // namespace gt
