#pragma once
#include "framework/Layout.h"

namespace gt {

/// All that is wrong with a layout's text, in the order in which it was found, where parseLayout
/// and makePlan tell the first; nothing if it is sound.
std::vector<Error> checkLayoutText(std::string_view text, const std::string& file,
                                   const SolutionTable& table,
                                   const std::vector<const RepresentationType*>& platform,
                                   const std::vector<const RepresentationType*>& given);

}  // namespace gt
