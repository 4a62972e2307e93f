#pragma once
#include <string>

namespace gt {

/// What `simgt check` is told.
struct CheckOptions {
  std::string root;
  bool strict = false;  ///< Warnings are failures, too.
};

/// Loads every configuration, layout, scene, motion and behavior of a tree and reports all
/// errors and warnings, sorted by file and line. Returns the exit status.
int checkTree(const CheckOptions& options);

}  // namespace gt
