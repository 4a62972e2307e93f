#pragma once
#include <string>

#include "base/Time.h"
#include "labels/LabelErrors.h"

namespace gt {

/// A script of the console that goes to an image of a log and fails if vision does not find the
/// labeled objects in it. The tolerance (pixels) applies to the ball's position and radius.
std::string scriptOfLabels(const ImageLabels& labels, int picture, const std::string& log,
                           Time played, double tolerance);

}  // namespace gt
