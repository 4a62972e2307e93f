#pragma once
#include "streams/MessageQueue.h"
#include "streams/Streams.h"

/// Streams whose medium is a message queue (report D.2, E.1), for messages that are written piece
/// by piece. Where a message is one value, MessageQueue::write() and Message::read() are shorter
/// and faster.
namespace gt {

/// A stream that writes messages into a queue, which must outlive it. Each message consists of the
/// data written since the previous one was finished.
template <std::derived_from<StreamWriter> Format>
class OutMessage : public OutStream<OutMemory, Format> {
 public:
  explicit OutMessage(MessageQueue& queue) : queue_{queue} {}
  /// Appends the message to the queue. Returns false if the queue is full.
  bool finishMessage(std::uint32_t id, Time time) {
    const bool done = queue_.append({id, time, this->bytes()});
    this->reset();
    return done;
  }

 private:
  MessageQueue& queue_;
};

/// Reads a message of a queue, which must outlive the stream. A message can be read repeatedly,
/// each time by a new stream.
class InMessageQueue : public InMemory {
 public:
  explicit InMessageQueue(const Message& message) : InMemory{message.bytes} {}
};

using OutBinaryMessage = OutMessage<OutBinary>;
using OutTextMessage = OutMessage<OutText>;
using InBinaryMessage = InStream<InMessageQueue, InBinary>;
using InTextMessage = InStream<InMessageQueue, InText>;
using InConfigMessage = InStream<InMessageQueue, InConfig>;

}  // namespace gt
