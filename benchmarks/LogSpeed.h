#pragma once
#include "base/DataRoot.h"
#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// Measures writing and reading of logs, in MB of messages a second of the processor's time, with
/// and without compression, beside zstd alone on the same bytes: `speed.log.*`. The messages are
/// those of a robot in a match with all that it sensed, images included.
Result<void> measureLogSpeed(Figures& figures, const DataRoot& root);

}  // namespace gt
