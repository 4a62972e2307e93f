#pragma once
#include <string>

#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// Writes the figures of the self-locators as one page that opens offline: charts beside the
/// report's figures, the table of robustness, all figures.
Result<void> writeLocalizationPage(const std::string& path, const Figures& figures);

}  // namespace gt
