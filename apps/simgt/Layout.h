#pragma once
#include <string>

#include "base/Result.h"

namespace gt {

/// What `simgt layout` was asked for.
struct LayoutOptions {
  std::string layout;
  std::string svg;  ///< File for a drawing; none if empty.
};

/// Prints what runs in which process and what crosses between them. Returns an error if a file
/// is wrong.
Result<void> showLayout(const LayoutOptions& options);

}  // namespace gt
