#pragma once
#include "observer/LogSelection.h"

namespace gt {

/// What is in a log, for a person: times, channels with counts and rates, metadata, attachments.
Result<std::string> describeLog(const std::string& path);

}  // namespace gt
