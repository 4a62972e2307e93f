#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "xabsl/formats/xml/XmlTree.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl::xml {

/// True for the text of an XML file, false for XABSL text.
bool isXml(std::string_view text);

/// Converts the text of an XML file from its declared encoding to UTF-8. Returns false if this is
/// impossible.
bool toUtf8(std::string& text);

/// Reads one file, whose text is UTF-8 and whose index in the reporter is `index`. Included files
/// are not read. Errors are reported.
void readElements(int index, std::string_view text, Reporter& reporter, syntax::Program& program,
                  File& file);

/// The files that a document type definition names: `<!ENTITY name SYSTEM "path">`.
std::map<std::string, std::string, std::less<>> readEntities(std::string_view text);

}  // namespace xabsl::xml
