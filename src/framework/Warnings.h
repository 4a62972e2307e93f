#pragma once
#include <string>

#include "base/Findings.h"
#include "streams/MessageQueue.h"

namespace gt {

/// What messages of a robot report as wrong: texts that are warnings or errors, requests that were
/// refused, messages for which a queue had no room. A run that is strict fails by each of them.
Findings warningsIn(const MessageQueue& messages, const std::string& robot);

}  // namespace gt
