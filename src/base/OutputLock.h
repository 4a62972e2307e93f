#pragma once
#include <string>

#include "base/FileDescriptor.h"
#include "base/Result.h"

namespace gt {

/// Keeps a folder or a file for what one program writes. Whoever takes the lock while another one,
/// also of this program, holds it gets an error. It ends with the object, and with the program,
/// however that ends.
class OutputLock {
 public:
  /// Makes the folder if it is not there.
  static Result<OutputLock> ofFolder(const std::string& folder);
  /// Makes an empty file if there is none.
  static Result<OutputLock> ofFile(const std::string& file);
  OutputLock(OutputLock&& other) noexcept = default;
  OutputLock& operator=(OutputLock&& other) noexcept = default;
  ~OutputLock();

 private:
  explicit OutputLock(FileDescriptor file, std::string remove = {})
      : file_{std::move(file)}, remove_{std::move(remove)} {}

  FileDescriptor file_;
  std::string remove_;  ///< Is removed at the end; empty: nothing.
};

}  // namespace gt
