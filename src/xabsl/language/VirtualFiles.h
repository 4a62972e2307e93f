#pragma once

#include <map>
#include <string>

namespace xabsl {

/// Files held in memory: text by path. Includes are looked up relative to the including file, as on
/// disk.
using VirtualFiles = std::map<std::string, std::string>;

}  // namespace xabsl
