#pragma once
#include "streams/MessageQueue.h"
#include "streams/Streams.h"

/// Streams whose medium is a message queue (report D.2, E.1), for messages that are written piece
/// by piece. Where a message is one value, MessageQueue::write() and Message::read() are shorter
/// and faster.
namespace gt {

/// Writes messages into a message queue, which must outlive it.
class OutMessageQueue : public OutMemory {
 public:
  explicit OutMessageQueue(MessageQueue& queue) : queue_{queue} {}

 protected:
  bool finish(std::uint32_t id, Time time) { return queue_.append({id, time, bytes()}); }

 private:
  MessageQueue& queue_;
};

/// A stream of messages: what was written since the last one was finished becomes the next one.
template <std::derived_from<StreamWriter> Format>
class OutMessage : public OutStream<OutMessageQueue, Format> {
 public:
  using OutStream<OutMessageQueue, Format>::OutStream;
  /// Appends the message to the queue; false if there was no room for it.
  bool finishMessage(std::uint32_t id, Time time) {
    const bool done = this->finish(id, time);
    this->reset();
    return done;
  }
};

/// Reads from a message of a queue, which must outlive it. A message can be read as often as one
/// likes, each time by a new stream.
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
