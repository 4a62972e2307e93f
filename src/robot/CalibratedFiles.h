#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/Findings.h"
#include "streams/Reflection.h"

namespace gt {

/// A file with measured or optimized numbers, which are valid only for the data they depend on.
struct CalibratedFile {
  std::string file;     ///< Path in the tree.
  std::string command;  ///< Command that creates the file again, for people.
  /// The file's dependencies: files of the tree, or folders with all their files. Each has a
  /// fingerprint of the time when the file was last found valid; comments and blanks are ignored.
  std::vector<std::array<std::string, 2>> sources;

  static constexpr auto fields() {
    return Fields{field<&CalibratedFile::file>(), field<&CalibratedFile::command>(),
                  field<&CalibratedFile::sources>()};
  }
};

/// All calibrated files of a tree: config/calibrated.cfg.
struct CalibratedFiles {
  std::vector<CalibratedFile> files;

  static constexpr auto fields() { return Fields{field<&CalibratedFiles::files>()}; }
};

/// Warns of calibrated files with dependencies that have changed since. A listed file that is
/// missing is an error, except in an installation, which has no folder src.
Findings checkCalibratedFiles(const std::string& root);

/// Marks a calibrated file in the list as valid for the present state of its dependencies.
Result<void> keepCalibratedFile(const std::string& root, const std::string& file);

}  // namespace gt
