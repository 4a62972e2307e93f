#include "base/UnfinishedFile.h"

#include <cstdio>

namespace gt {

UnfinishedFile::~UnfinishedFile() {
  if (!finished_ && written_ != path_) std::remove(written_.c_str());
}

Result<void> UnfinishedFile::finish() {
  auto done = finishFile(path_, written_);
  finished_ = static_cast<bool>(done);
  return done;
}

}  // namespace gt
