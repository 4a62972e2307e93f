#pragma once

#include <string>

#include "xabsl/formats/xml/XmlTree.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/SourceFiles.h"

namespace xabsl::xml {

/// Reads a file and all that it includes by external entities and XInclude, each once (report F.1).
/// Refused with a message: what is not a file in the folder of the first one or below it, circles,
/// and what gets too large when all is in its place.
Files readFiles(const std::string& path, SourceFiles sources, syntax::Program& program,
                Reporter& reporter);

}  // namespace xabsl::xml
