#pragma once

#include <optional>
#include <string>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// Writes pages about a behavior into a folder, `index.html` first (report G): charts of agents,
/// options and decision trees, what each option reads and writes, who uses each symbol. They need
/// neither a network nor a server, and the same behavior gives the same files. Charts are drawn by
/// Graphviz. Returns what went wrong.
std::optional<Diagnostic> writeDocumentation(const Model& model, const std::string& folder);

}  // namespace xabsl
