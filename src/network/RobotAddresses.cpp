#include "network/RobotAddresses.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <filesystem>
#include <set>

#include "base/File.h"
#include "base/UserFolder.h"

namespace gt {

std::string RobotAddresses::endpoint(const std::string& process) const {
  const auto found = elsewhere.find(process);
  return found != elsewhere.end() ? found->second : "ipc://" + folder + "/" + robot + "." + process;
}

Result<void> checkEndpoint(const std::string& endpoint) {
  const std::string_view text{endpoint};
  const auto port = text.rfind(':');
  const bool local = text.starts_with("ipc://") && text.size() > 6;
  const bool reachable =
      text.starts_with("tcp://") && port > 6 && port + 1 < text.size() &&
      (text.substr(port + 1) == "*" || text.find_first_not_of("0123456789", port + 1) == text.npos);
  if (local || reachable) return {};
  return Error{.file = "network",
               .field = endpoint,
               .what = "expected an endpoint, as tcp://10.0.1.100:5001 or ipc:///tmp/robot.Tools"};
}

std::string machineAddress() {
  std::set<std::string> addresses;  // by interface, so the first is always the same
  std::error_code failed;
  for (const auto& interface : std::filesystem::directory_iterator{"/sys/class/net", failed}) {
    const auto text = readFile((interface.path() / "address").string());
    std::string address;
    for (const char c : text ? *text : std::string{})
      if (std::isxdigit(static_cast<unsigned char>(c)))
        address += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (address.size() == 12 && address != std::string(12, '0'))
      addresses.insert(interface.path().filename().string() + " " + address);
  }
  return addresses.empty() ? "" : addresses.begin()->substr(addresses.begin()->size() - 12);
}

std::string defaultSocketFolder() {
  const std::string runtime = userFolder(UserFolder::runtime);
  return runtime.empty() ? "/tmp/gt2003-" + std::to_string(getuid()) : runtime;
}

Result<void> makePrivateFolder(const std::string& folder) {
  mkdir(folder.c_str(), 0700);
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return Error{.file = folder, .what = "is no folder, and cannot be made"};
  if (status.st_uid != getuid() || (status.st_mode & 0077) != 0)
    return Error{.file = folder,
                 .what = "others have access to it; it shall be the user's alone (0700)"};
  return {};
}

}  // namespace gt
