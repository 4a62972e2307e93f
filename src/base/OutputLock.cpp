#include "base/OutputLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace gt {
namespace {

/// Opens a file and locks it, unless it is a device or a pipe, which several may write. Errors name
/// `output`.
Result<FileDescriptor> lockedFile(const std::string& path, const std::string& output) {
  const auto failed = [&](const std::string& what) { return Error{.file = output, .what = what}; };
  FileDescriptor file{open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)};
  if (!file) return failed(std::string{"cannot be written: "} + std::strerror(errno));
  struct stat status {};
  if (fstat(file.number(), &status) == 0 && !S_ISREG(status.st_mode)) return file;
  if (flock(file.number(), LOCK_EX | LOCK_NB) == 0) return file;
  if (errno == EWOULDBLOCK) return failed("is being written by another program or match");
  return failed(std::string{"cannot be locked: "} + std::strerror(errno));
}

/// Whether a path still names a file that is open.
bool names(const std::string& path, const FileDescriptor& file) {
  struct stat opened {
  }, named{};
  return fstat(file.number(), &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

// Locks a file in the folder, since folders on other machines cannot be locked.
Result<OutputLock> OutputLock::ofFolder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) return Error{.file = folder, .what = failed.message()};
  const std::string path = (std::filesystem::path{folder} / ".lock").string();
  for (;;) {
    auto file = lockedFile(path, folder);
    if (!file) return file.error();
    // The previous owner of the lock may have removed the file since it was opened here.
    if (names(path, *file)) return OutputLock{std::move(*file), path};
  }
}

Result<OutputLock> OutputLock::ofFile(const std::string& file) {
  auto locked = lockedFile(file, file);
  if (!locked) return locked.error();
  return OutputLock{std::move(*locked)};
}

OutputLock::~OutputLock() {
  if (file_ && !remove_.empty() && names(remove_, file_)) unlink(remove_.c_str());
}

}  // namespace gt
