#pragma once
#include <string>
#include <utility>

#include "base/File.h"

namespace gt {

/// A file on its way to being whole: it is written under another name until it is finished. If it
/// never is, it is removed, and a file that was there before stays. For what libraries and other
/// programs write; this program's own text goes to an OutputFile. To be made once nobody else may
/// write the file.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::string path)
      : path_{std::move(path)}, written_{unfinishedName(path_)} {}
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;
  ~UnfinishedFile();

  const std::string& path() const { return path_; }
  /// The name under which it is written.
  const std::string& written() const { return written_; }
  /// Gives the file its own name.
  Result<void> finish();

 private:
  std::string path_, written_;
  bool finished_ = false;
};

}  // namespace gt
