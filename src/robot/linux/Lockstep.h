#pragma once
#include <string>
#include <vector>

#include "network/QueueStream.h"
#include "robot/linux/RobotProgram.h"

namespace gt {

/// Of how a robot and a simulator take turns. A robot's program begins with its `LockstepGreeting`
/// and how its camera is set, or with a `LockstepFailure`; the simulator answers with its schemas.
/// Then the simulator sends what the body measured in a tick, and the robot its commands and what
/// it believes, again and again, until the simulator closes the connection.
constexpr int lockstepProtocol = 1;

/// What a robot in lockstep tells of itself.
struct LockstepGreeting {
  int protocol = 0;
  std::string commit;              ///< From which its program was built.
  std::vector<std::string> kicks;  ///< Its special actions that are kicks.

  static constexpr auto fields() {
    return Fields{field<&LockstepGreeting::protocol>(), field<&LockstepGreeting::commit>(),
                  field<&LockstepGreeting::kicks>()};
  }
};

/// The names of the special actions that are kicks.
std::vector<std::string> kickNames(const MotionNet& net);

/// Why a robot in lockstep cannot be started: an Error.
struct LockstepFailure {
  std::string file;
  int line = 0, column = 0;
  std::string element;  ///< The error's field.
  std::string what;

  static constexpr auto fields() {
    return Fields{field<&LockstepFailure::file>(), field<&LockstepFailure::line>(),
                  field<&LockstepFailure::column>(), field<&LockstepFailure::element>(),
                  field<&LockstepFailure::what>()};
  }
};

/// What robots in lockstep and the simulator may send each other.
const Vocabulary& lockstepVocabulary();
/// The capacity of its queues: an image of the largest camera, and the rest.
constexpr std::size_t lockstepQueueSize = 8 << 20;

/// Runs a whole robot in this program, as fast as the simulator at the other end of the socket
/// sends what it senses: the same in, the same bits out. The clock of the messages is its only one.
/// Returns when the simulator closes the connection.
Result<void> runInLockstep(const RobotProgramOptions& options, const RobotModules& modules,
                           FileDescriptor socket);

}  // namespace gt
