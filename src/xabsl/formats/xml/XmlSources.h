#pragma once

#include <string>

#include "xabsl/formats/xml/XmlTree.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/SourceFiles.h"

namespace xabsl::xml {

/// Reads a file and all that it includes by external entities and XInclude, each once (report F.1).
/// Refuses with a message: files outside of the first one's folder, circular inclusions, and
/// behaviors that are too large after expansion.
Files readFiles(const std::string& path, SourceFiles sources, syntax::Program& program,
                Reporter& reporter);

}  // namespace xabsl::xml
