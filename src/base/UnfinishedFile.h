#pragma once
#include <string>
#include <utility>

#include "base/File.h"

namespace gt {

/// Writes a file completely or not at all: it is written under a temporary name until finish().
/// Without finish(), it is removed, and a previous file of that name is kept. For files that
/// libraries and other programs write; this program's own text goes to an OutputFile. Must be
/// created once no other program may write the file.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string path)
      : path_{std::move(path)}, written_{unfinishedName(path_)} {}
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();

  const std::string& path() const { return path_; }
  /// The temporary name under which the file is written.
  const std::string& written() const { return written_; }
  /// Renames the file to its own name.
  Result<void> finish();

 private:
  std::string path_, written_;
  bool finished_ = false;
};

}  // namespace gt
