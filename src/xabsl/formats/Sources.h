#pragma once

#include <string>

#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

/// Reads a behavior, as text or XML, from a file and all files that it includes, each once. The
/// program holds the texts and sets the version of text. Errors go to the reporter.
void readSources(const std::string& path, const FileReader& read, syntax::Program& program,
                 Reporter& reporter);

/// Reports that a sound program has no agent: a part of a behavior does not know the rest, and all
/// other errors would follow from that.
void requireAgents(const syntax::Program& program, Reporter& reporter);

}  // namespace xabsl
