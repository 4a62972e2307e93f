#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace motionnet {

/// The name of a motion in XABSL: pushStrong is push_strong there.
std::string xabslName(std::string_view motion);

/// Motions as a file of XABSL, which declares the enumeration special_action (report 5.4, F.2):
/// none, then the motions.
std::string listing(const std::vector<std::string>& motions);

}  // namespace motionnet
