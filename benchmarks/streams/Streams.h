#pragma once
#include "measure/Figures.h"

namespace gt {

/// Streams representations binary, side by side with Protocol Buffers carrying the same fields,
/// from and to the structs: size, writing and reading, `speed.stream.<representation>.<what>`.
/// Without Protocol Buffers nothing is measured, and that is reported.
void measureStreams(Figures& figures);

}  // namespace gt
