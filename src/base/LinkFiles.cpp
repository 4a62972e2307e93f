#include "base/LinkFiles.h"

namespace gt {

namespace fs = std::filesystem;

Result<void> linkFiles(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  fs::create_directories(to, failed);
  for (fs::recursive_directory_iterator at{from, failed}, end; !failed && at != end;
       at.increment(failed)) {
    const fs::path place = to / at->path().lexically_relative(from);
    if (at->is_directory(failed)) {
      fs::create_directory(place, failed);
    } else {
      fs::remove(place, failed);
      fs::create_symlink(at->path(), place, failed);
    }
    if (failed) break;
  }
  if (failed) return Error{.file = from.string(), .what = failed.message()};
  return {};
}

}  // namespace gt
