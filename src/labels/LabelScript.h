#pragma once
#include <string>

#include "base/Time.h"
#include "labels/LabelErrors.h"

namespace gt {

/// A script of the console that goes to an image of a log, where it was played, and fails if vision
/// does not find there what is labeled. Places and radius of a ball may be off by a tolerance
/// (pixels).
std::string scriptOfLabels(const ImageLabels& labels, int picture, const std::string& log,
                           Time played, double tolerance);

}  // namespace gt
