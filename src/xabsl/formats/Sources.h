#pragma once

#include <string>

#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// Reads a behavior, as text or XML, from a file and all files that it includes, each once. The
/// program stores the texts; its dialect selects the version of text. Errors go to the reporter.
void readSources(const std::string& path, const FileReader& read, syntax::Program& program,
                 Reporter& reporter);

/// Reports an error if a program without other errors has no agent. Such a file is a part of a
/// behavior, and all further errors would follow from the missing rest.
void requireAgents(const syntax::Program& program, Reporter& reporter);

}  // namespace xabsl
