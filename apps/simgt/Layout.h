#pragma once
#include <string>

namespace gt {

/// What `simgt layout` was asked for.
struct LayoutOptions {
  std::string layout;
  std::string svg;  ///< File for a drawing; none if empty.
};

/// Prints what runs in which process and what crosses between them. Returns the program's exit
/// status: 2 if a file is wrong.
int showLayout(const LayoutOptions& options);

}  // namespace gt
