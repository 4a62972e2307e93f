#include "robot/linux/RobotAddresses.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace gt {

std::string RobotAddresses::endpoint(const std::string& process) const {
  const auto told = elsewhere.find(process);
  return told != elsewhere.end() ? told->second : "ipc://" + folder + "/" + robot + "." + process;
}

std::string defaultSocketFolder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  return runtime && *runtime ? std::string{runtime} + "/gt2003"
                             : "/tmp/gt2003-" + std::to_string(getuid());
}

Result<void> makePrivateFolder(const std::string& folder) {
  mkdir(folder.c_str(), 0700);
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return Error{folder, 0, "", "is no folder, and cannot be made"};
  if (status.st_uid != getuid() || (status.st_mode & 0077) != 0)
    return Error{folder, 0, "", "others have access to it; it shall be the user's alone (0700)"};
  return {};
}

}  // namespace gt
