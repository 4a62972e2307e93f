#pragma once
#include <string>

#include "base/Result.h"

namespace gt {

/// Quotes a text for Graphviz's language.
std::string dotQuoted(const std::string& text);

/// Lets Graphviz draw into an SVG file; an error if its program `dot` is missing or fails.
Result<void> writeSvg(const std::string& drawing, const std::string& file);

}  // namespace gt
