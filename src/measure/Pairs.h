#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "base/Geometry.h"

namespace gt {

/// Assigns percepts to places one to one, the nearest pair first, up to a greatest distance.
/// Returns for each place the index of its percept, or nothing.
std::vector<std::optional<std::size_t>> pairNearest(const std::vector<Vector2d>& places,
                                                    const std::vector<Vector2d>& percepts,
                                                    double tolerance);

}  // namespace gt
