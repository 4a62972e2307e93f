#pragma once
#include <string>

#include "motionnet/Net.h"

namespace motionnet {

/// The motions, extern excluded, as an XML document with an enumerated output symbol of XABSL
/// (report 5.4, F.2), so that behaviours know them by name.
std::string listing(const Net&);

}  // namespace motionnet
