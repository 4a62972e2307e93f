#pragma once
#include "representations/perception/ColorTable64.h"

namespace gt {

/// Whether a table has classes, but not those of every field: green, white and gray. Then its file
/// was probably written in another order of class numbers than it was read in.
bool seemsOfOtherOrder(const ColorTable64& table);

}  // namespace gt
