#pragma once
#include <string>
#include <vector>

#include "network/QueueStream.h"
#include "robot/linux/RobotProgram.h"

namespace gt {

/// Version of the protocol by which a robot and a simulator alternate. The robot's program first
/// sends its `LockstepGreeting` and its camera settings, or a `LockstepFailure`; the simulator
/// answers with its schemas. Then the simulator sends the body's measurements of a tick, and the
/// robot its commands and beliefs, repeatedly, until the simulator closes the connection.
constexpr int lockstepProtocol = 1;

/// The first message of a robot in lockstep, about itself.
struct LockstepGreeting {
  int protocol = 0;
  std::string commit;              ///< Commit from which its program was built.
  std::vector<std::string> kicks;  ///< Names of its special actions that are kicks.

  static constexpr auto fields() {
    return Fields{field<&LockstepGreeting::protocol>(), field<&LockstepGreeting::commit>(),
                  field<&LockstepGreeting::kicks>()};
  }
};

/// The names of the special actions that are kicks.
std::vector<std::string> kickNames(const MotionNet& net);

/// The reason why a robot in lockstep cannot be started: an Error.
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

/// The message types that robots in lockstep and the simulator may send each other.
const Vocabulary& lockstepVocabulary();
/// Capacity (bytes) of the queues: an image of the largest camera, and the other messages.
constexpr std::size_t lockstepQueueSize = 8 << 20;

/// Runs a whole robot in this program, as fast as the simulator at the other end of the socket
/// sends sensor data. The same input yields the same output, bit for bit. The time in the messages
/// is the only clock. Returns when the simulator closes the connection.
Result<void> runInLockstep(const RobotProgramOptions& options, const RobotModules& modules,
                           FileDescriptor socket);

}  // namespace gt
