#pragma once

#include <optional>
#include <string>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// Writes pages about a behavior into a folder, `index.html` first (report G): charts of agents,
/// options and decision trees, what each option reads and writes, which options use each symbol.
/// The pages need neither a network nor a server, and the same behavior yields the same files.
/// Charts are drawn by Graphviz. Returns the error, if there is one.
std::optional<Diagnostic> writeDocumentation(const Model& model, const std::string& folder);

}  // namespace xabsl
