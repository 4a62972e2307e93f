#pragma once
#include <string>

namespace gt {

/// The arguments of `simgt check`.
struct CheckOptions {
  std::string root;
  bool strict = false;  ///< Warnings are failures, too.
};

/// Loads every configuration, layout, scene, motion and behavior of a tree and reports all
/// errors and warnings, sorted by file and line. Returns the exit status.
int checkTree(const CheckOptions& options);

}  // namespace gt
