#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/Reporter.h"
#include "xabsl/Syntax.h"
#include "xabsl/XmlTree.h"

namespace xabsl::xml {

/// True for the text of an XML file, false for XABSL text.
bool isXml(std::string_view text);

/// Converts the text of an XML file from the encoding that it declares to UTF-8; false: it cannot
/// be done.
bool toUtf8(std::string& text);

/// Reads the elements of one file, whose text is UTF-8 and known to the reporter by the index
/// `file`. Nothing else is read: inclusions stay what they are. What is wrong is reported.
std::vector<Element> readElements(int file, std::string_view text, Reporter& reporter,
                                  syntax::Program& program);

}  // namespace xabsl::xml
