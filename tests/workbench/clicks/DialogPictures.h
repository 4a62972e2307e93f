#pragma once
#include <string>

#include "base/DataRoot.h"
#include "base/Result.h"

namespace gt {

/// Pictures of all dialogs of the workbench.
struct DialogPictures {
  DataRoot root;
  std::string settings;               ///< JSON: what dialogs show, by their names in layouts.
  std::string out = "out/workbench";  ///< For the window with each dialog, a folder for each look.
  std::string dialogs{};              ///< For each dialog alone, in a light window; empty: none.
  std::string only{};                 ///< One dialog; empty: all.
};

/// Takes them in light and dark windows of two sizes.
Result<void> takePictures(const DialogPictures& options);

}  // namespace gt
