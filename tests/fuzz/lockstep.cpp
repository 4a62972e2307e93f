#include <sys/socket.h>

#include <algorithm>
#include <span>

#include "Fuzz.h"
#include "match/LockstepRobot.h"

namespace {

using namespace gt;

/// A queue with one message of a type that robots and simulators send; the first byte selects it.
MessageQueue queueOf(std::span<const std::byte> bytes) {
  MessageQueue queue;
  const auto& types = lockstepVocabulary().descriptions().types;
  const std::size_t chosen = bytes.empty() ? 0 : static_cast<std::size_t>(bytes[0]) % types.size();
  if (!bytes.empty()) bytes = bytes.subspan(1);
  if (std::byte* place = queue.reserve(types[chosen].type, "", Time{}, bytes.size()))
    std::ranges::copy(bytes, place);
  return queue;
}

}  // namespace

/// What a robot's program in lockstep sends: as a stream, as a greeting, or as an answer. The first
/// byte selects it.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most = 50'000;  // what a socket takes without anyone who reads
  int ends[2];
  if (size == 0 || size > most || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return 0;
  const std::span bytes = std::as_bytes(std::span{data, size}).subspan(1);
  constexpr std::chrono::seconds patience{1};
  LockstepRobot robot{"red1", FileDescriptor{ends[0]}, patience};
  {
    FileDescriptor socket{ends[1]};
    if (data[0] % 3 == 0) {
      if (send(socket.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL) < 0) return 0;
    } else {
      QueueStream program{std::move(socket), lockstepVocabulary(), lockstepQueueSize, patience};
      MessageQueue greeting;
      greeting.write(Time{}, LockstepGreeting{lockstepProtocol, "", {}});
      (void)!program.introduce(data[0] % 3 == 1 ? queueOf(bytes) : greeting);
      if (data[0] % 3 == 2) (void)!program.send(queueOf(bytes));
    }
  }
  (void)!robot.greet();
  RobotInput input;
  RobotOutput output;
  robot.cycle(input, output);
  robot.finish(output);
  return 0;
}
