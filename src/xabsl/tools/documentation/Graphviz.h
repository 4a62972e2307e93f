#pragma once

#include <optional>
#include <string>
#include <vector>

namespace xabsl::documentation {

/// Draws graphs in Graphviz's language, all with one run of its program `dot`, and replaces each by
/// an `<svg>` element for a page; empty ones stay empty. Temporary files are in the folder. Returns
/// the reason if it fails.
std::optional<std::string> draw(const std::vector<std::string*>& graphs, const std::string& folder);

}  // namespace xabsl::documentation
