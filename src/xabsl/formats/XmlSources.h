#pragma once

#include <string>

#include "xabsl/formats/Sources.h"
#include "xabsl/formats/XmlTree.h"
#include "xabsl/language/Reporter.h"

namespace xabsl::xml {

/// Reads a file and all that it includes by external entities and XInclude, each once (report F.1).
/// Refused with a message: what is not a file in the folder of the first one or below it, circles,
/// and what gets too large when all is in its place.
Files readFiles(const std::string& path, SourceFiles sources, syntax::Program& program,
                Reporter& reporter);

}  // namespace xabsl::xml
