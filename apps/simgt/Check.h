#pragma once
#include <string>

namespace gt {

/// The arguments of `simgt check`.
struct CheckOptions {
  std::string root;
  bool strict = false;  ///< Warnings are failures, too.
  std::string fits;     ///< A calibrated file that was just measured to fit: only this is kept.
};

/// Loads every configuration, layout, scene, motion and behavior of a tree and reports all
/// errors and warnings, sorted by file and line. Returns the exit status.
int checkTree(const CheckOptions& options);

}  // namespace gt
