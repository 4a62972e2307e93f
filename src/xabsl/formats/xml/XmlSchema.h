#pragma once

#include "xabsl/formats/xml/XmlTree.h"
#include "xabsl/language/Reporter.h"

namespace xabsl::xml {

/// Validates files against the XML Schemas of their version of XABSL (report F.1): each separately,
/// then all as a whole. Errors are reported.
void validate(const Files& files, Reporter& reporter);

}  // namespace xabsl::xml
