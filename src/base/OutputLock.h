#pragma once
#include <string>

#include "base/FileDescriptor.h"
#include "base/Result.h"

namespace gt {

/// Locks a folder or a file for the output of one program. Locking fails with an error while the
/// lock is held elsewhere, also by this program. The lock ends with the object, and at the latest
/// with the program, however that ends.
class OutputLock {
 public:
  /// Creates the folder if it does not exist.
  static Result<OutputLock> ofFolder(const std::string& folder);
  /// Creates an empty file if it does not exist.
  static Result<OutputLock> ofFile(const std::string& file);
  OutputLock(OutputLock&& other) noexcept = default;
  OutputLock& operator=(OutputLock&& other) noexcept = default;
  ~OutputLock();

 private:
  explicit OutputLock(FileDescriptor file, std::string remove = {})
      : file_{std::move(file)}, remove_{std::move(remove)} {}

  FileDescriptor file_;
  std::string remove_;  ///< Path that is removed at the end; empty if none.
};

}  // namespace gt
