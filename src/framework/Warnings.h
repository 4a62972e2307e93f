#pragma once
#include <string>

#include "base/Findings.h"
#include "streams/MessageQueue.h"

namespace gt {

/// The problems reported in a robot's messages: texts that are warnings or errors, requests that
/// were refused, messages for which a queue had no room. Each of them makes a strict run fail.
Findings warningsIn(const MessageQueue& messages, const std::string& robot);

}  // namespace gt
