#pragma once
#include <string>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// A warning about a table that was probably read with the wrong order of class numbers: it has
/// classes, but none of those that every field has: green, white and gray. The table was read in
/// the order of a robot of 2009 (`nao2009`), or in that of the report. `remedy` describes how to
/// read it in the other order. Empty if there is no reason for a warning.
std::string doubtOfOrder(const ColorTable64& table, const std::string& file, bool nao2009,
                         const std::string& remedy);

}  // namespace gt
