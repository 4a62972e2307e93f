#pragma once
#include <string>

#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// Writes the figures of the self-locators as one page that opens offline: charts beside the
/// report's figures, the table of robustness, all figures. `note` stands at the top.
Result<void> writeLocalizationPage(const std::string& path, const Figures& figures,
                                   const std::string& note);

}  // namespace gt
