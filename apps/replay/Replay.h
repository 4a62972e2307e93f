#pragma once
#include <functional>
#include <string>

#include "base/DataRoot.h"
#include "base/Result.h"
#include "measure/real/Comparison.h"
#include "robot/replay/LogPlatform.h"

namespace gt {

/// The files of a replay.
struct ReplayFiles {
  DataRoot root{};  ///< Where files lie by default.
  std::string log{}, colors{};
  std::string config = root.path("config/nao2009");
  std::string layout = root.path("layouts/replay.layout");
  std::string labels = root.path("tests/real/nao2009-labels.csv");  ///< Empty for none.
};

/// Runs a robot on a log, with percepts drawn, and calls `look(platform, ball, label)` after
/// each image; the label is null where nobody looked.
using ReplayVisitor =
    std::function<Result<void>(const LogPlatform&, const BallPercept&, const BallLabel*)>;
Result<void> replay(const ReplayFiles& files, const ReplayVisitor& look);

}  // namespace gt
