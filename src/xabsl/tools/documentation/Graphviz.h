#pragma once

#include <optional>
#include <string>
#include <vector>

namespace xabsl::documentation {

/// Draws graphs in Graphviz's language, all with one run of its program `dot`, and puts in the
/// place of each one an `<svg>` element to stand in a page; empty ones stay empty. Files that this
/// needs for a while lie in the folder. Returns why it cannot.
std::optional<std::string> draw(const std::vector<std::string*>& graphs, const std::string& folder);

}  // namespace xabsl::documentation
