#pragma once
#include <vector>

#include "match/MatchSummary.h"
#include "representations/infrastructure/Image.h"

namespace gt {

/// A made-up match with everything that a report shows: eight robots, ten minutes, five goals.
MatchSummary sampleMatch(std::uint64_t seed);

/// The computing times of a made-up match.
MatchTimes sampleTimes();

/// A made-up camera image with noise: carpet, wall, and a ball at a place (pixels).
Image sampleImage(std::uint64_t seed, const Vector2d& ball, double radius);

/// Made-up camera images with percepts painted on them.
std::vector<ReportPicture> samplePictures(std::uint64_t seed, int count);

}  // namespace gt
