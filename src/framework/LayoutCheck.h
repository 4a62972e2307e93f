#pragma once
#include "base/Findings.h"
#include "framework/Layout.h"

namespace gt {

/// All that is wrong with a layout's text, where parseLayout and makePlan return the first error.
Findings checkLayoutText(std::string_view text, const std::string& file, const SolutionTable& table,
                         const std::vector<const RepresentationType*>& platform,
                         const std::vector<const RepresentationType*>& given);

}  // namespace gt
