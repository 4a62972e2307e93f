#pragma once
#include "base/Findings.h"
#include "framework/Layout.h"

namespace gt {

/// Returns all errors in a layout's text; parseLayout and makePlan return only the first one.
Findings checkLayoutText(std::string_view text, const std::string& file, const SolutionTable& table,
                         const std::vector<const RepresentationType*>& platform,
                         const std::vector<const RepresentationType*>& given);

}  // namespace gt
