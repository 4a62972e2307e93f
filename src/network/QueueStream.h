#pragma once
#include <chrono>
#include <optional>
#include <vector>

#include "base/FileDescriptor.h"
#include "network/Vocabulary.h"
#include "streams/MessageQueue.h"

namespace gt {

/// Exchanges message queues with one other program over a connected stream socket: in order and
/// without loss, for programs that alternate. A queue is sent as its size (32 bits, little endian)
/// and its bytes. The other program may be built from another version: both programs first send
/// their schemas, and messages are then converted by `Interpreter`.
class QueueStream {
 public:
  using Milliseconds = std::chrono::milliseconds;

  /// `own` must outlive the stream. Sending and receiving return an error after the time limit;
  /// without a limit they wait for the other program. Queues larger than `capacity` (bytes) are an
  /// error.
  QueueStream(FileDescriptor socket, const Vocabulary& own, std::size_t capacity,
              std::optional<Milliseconds> patience = {});

  /// Sends a queue, preceded by this program's schemas.
  Result<void> introduce(const MessageQueue& messages);
  /// Sends a queue. Returns an error if the other program has ended, or does not read in time.
  Result<void> send(const MessageQueue& messages);
  /// Waits for the next queue. Returns false if the other program has closed the connection, and an
  /// error if no valid queue arrives in time.
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
  std::vector<std::byte> bytes_;  ///< Received bytes that were not used yet, and free space.
  std::size_t size_ = 0;          ///< Number of received bytes.
};

}  // namespace gt
