#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/Findings.h"
#include "streams/Reflection.h"

namespace gt {

/// A file with numbers that were measured or searched, so that they fit only what they were found
/// with.
struct CalibratedFile {
  std::string file;     ///< In the tree.
  std::string command;  ///< That makes it anew, for people.
  /// What it depends on: files of the tree, or folders with all files in them; and the fingerprint
  /// of each when the file was last measured to fit, in which comments and blanks do not count.
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

/// Warns of calibrated files that depend on something which has changed since. What is listed and
/// missing is an error, but in an installation, which has no folder src.
Findings checkCalibratedFiles(const std::string& root);

/// Writes into the list that a calibrated file fits what it depends on, as that is now.
Result<void> keepCalibratedFile(const std::string& root, const std::string& file);

}  // namespace gt
