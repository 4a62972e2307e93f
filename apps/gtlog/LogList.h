#pragma once
#include "logs/LogSelection.h"

namespace gt {

/// What is in a log, for a person: times, channels with counts and rates, metadata, attachments.
/// Appends what is damaged.
Result<std::string> describeLog(const std::string& path, std::vector<Error>& damage);

}  // namespace gt
