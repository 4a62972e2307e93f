#pragma once
#include <string>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// A warning about a table that was probably read in another order of class numbers than its file
/// was written in: it has classes, but not those of every field, green, white and gray. It was read
/// in the order of a robot of 2009, or in that of the report; `remedy` tells how to read it in the
/// other one. Empty if there is nothing to warn of.
std::string doubtOfOrder(const ColorTable64& table, const std::string& file, bool nao2009,
                         const std::string& remedy);

}  // namespace gt
