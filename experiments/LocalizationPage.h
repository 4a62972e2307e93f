#pragma once
#include <string>

#include "Figures.h"
#include "base/Result.h"

namespace gt {

/// Writes the figures of the self-locators as one page that opens offline: charts beside the
/// report's figures, the table of robustness, all figures.
Result<void> writeLocalizationPage(const std::string& path, const Figures& figures);

}  // namespace gt
