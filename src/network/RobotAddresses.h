#pragma once
#include <map>
#include <string>

#include "base/Result.h"

namespace gt {

/// The endpoints of a robot's processes: on one machine the socket `ROBOT.PROCESS` in a folder that
/// belongs to the user alone, otherwise the given endpoint.
struct RobotAddresses {
  std::string folder;
  std::string robot = "robot";
  std::map<std::string, std::string> elsewhere;  ///< Endpoints of processes on other machines:
                                                 ///< tcp://10.0.1.100:5001

  /// The endpoint on which a process listens.
  std::string endpoint(const std::string& process) const;
};

/// The name by which the other processes know a robot's hardware, or its substitute.
constexpr const char* platformProcess = "Platform";

/// Checks whether a text has the form of an endpoint: tcp://HOST:PORT or ipc://PATH.
Result<void> checkEndpoint(const std::string& endpoint);

/// The hardware address of this machine's first network interface, in the format of robot.cfg
/// (00022D1F626B); empty if there is none.
std::string machineAddress();

/// The folder for the sockets of this user's robots: $XDG_RUNTIME_DIR/gt2003, or one in /tmp.
std::string defaultSocketFolder();
/// Makes a folder that other users cannot access. Returns an error if it exists and other users
/// can.
Result<void> makePrivateFolder(const std::string& folder);

}  // namespace gt
