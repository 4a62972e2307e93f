#pragma once
#include <map>
#include <string>

#include "base/Result.h"

namespace gt {

/// Under which names a robot's processes are found: on one machine as `ROBOT.PROCESS` in a folder
/// that belongs to the user alone, elsewhere where one is given.
struct RobotAddresses {
  std::string folder;
  std::string robot = "robot";
  std::map<std::string, std::string> elsewhere;  ///< Endpoints by process: tcp://10.0.1.100:5001

  /// The endpoint on which a process listens.
  std::string endpoint(const std::string& process) const;
};

/// What the other processes know a robot's hardware by, or who takes its place.
constexpr const char* platformProcess = "Platform";

/// Whether a text can be an endpoint: tcp://HOST:PORT or ipc://PATH.
Result<void> checkEndpoint(const std::string& endpoint);

/// The hardware address of this machine's first network interface, as robot.cfg has it
/// (00022D1F626B); empty if there is none.
std::string machineAddress();

/// The folder for the sockets of this user's robots: $XDG_RUNTIME_DIR/gt2003, or one in /tmp.
std::string defaultSocketFolder();
/// Makes a folder that nobody else can look into; an error if it is there and others can.
Result<void> makePrivateFolder(const std::string& folder);

}  // namespace gt
