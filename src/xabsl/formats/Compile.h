#pragma once

#include <string>

#include "xabsl/language/Behavior.h"
#include "xabsl/language/Language.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// Compiles XABSL text, or XABSL 2.1 or 3.1 in XML, from the file with the agents and all that it
/// includes. `text` is the version of text: 3.1, or 3.0, which has no cooperation of robots. XML
/// states its version itself.
Compilation compile(const std::string& path, Dialect text = Dialect::xabsl31);

/// Compiles from files in memory.
Compilation compile(const std::string& path, const VirtualFiles& files,
                    Dialect text = Dialect::xabsl31);

/// Compiles from the files that a reader provides.
Compilation compile(const std::string& path, const FileReader& read,
                    Dialect text = Dialect::xabsl31);

}  // namespace xabsl
