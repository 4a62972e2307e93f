#pragma once
#include <chrono>
#include <optional>
#include <vector>

#include "base/FileDescriptor.h"
#include "network/Vocabulary.h"
#include "streams/MessageQueue.h"

namespace gt {

/// Exchanges queues of messages with one other program over a connected stream socket: in order and
/// without loss, for programs that take turns. A queue is its size (32 bits, little endian) and its
/// bytes. The other program may be built from another version: each introduces itself, and messages
/// are then read as `Interpreter` reads them.
class QueueStream {
 public:
  using Milliseconds = std::chrono::milliseconds;

  /// `own` must outlive the stream. Sending and receiving take at most so long; without a limit
  /// they wait for the other program. Larger queues than `capacity` are an error.
  QueueStream(FileDescriptor socket, const Vocabulary& own, std::size_t capacity,
              std::optional<Milliseconds> patience = {});

  /// Sends a queue, behind this program's schemas.
  Result<void> introduce(const MessageQueue& messages);
  /// An error if the other program has ended, or does not read in time.
  Result<void> send(const MessageQueue& messages);
  /// Waits for the next queue. Returns false if the other program has closed the connection. An
  /// error if nothing comes in time, or what comes is no queue.
  Result<bool> receive(MessageQueue& messages);

 private:
  using Clock = std::chrono::steady_clock;

  Result<bool> receiveBytes(std::size_t size);
  Result<void> waitFor(short events, Clock::time_point begin) const;

  FileDescriptor socket_;
  const Vocabulary& own_;
  std::optional<Milliseconds> patience_;
  Interpreter interpreter_;
  MessageQueue raw_;
  std::vector<std::byte> bytes_;  ///< That came in and were not used yet, and room for more.
  std::size_t size_ = 0;          ///< Of what came in.
};

}  // namespace gt
