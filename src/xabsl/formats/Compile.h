#pragma once

#include <string>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Language.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// Compiles XABSL as text, or 2.1 or 3.1 in XML, from the file with the agents and all that it
/// includes. Text is 3.1, or 3.0, which knows no cooperation of robots; XML states what it is.
Compilation compile(const std::string& path, Dialect text = Dialect::xabsl31);

/// The same from files in memory.
Compilation compile(const std::string& path, const VirtualFiles& files,
                    Dialect text = Dialect::xabsl31);

/// The same from wherever a reader reads.
Compilation compile(const std::string& path, const FileReader& read,
                    Dialect text = Dialect::xabsl31);

}  // namespace xabsl
