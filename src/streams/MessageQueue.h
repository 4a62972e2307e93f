#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/Time.h"
#include "streams/Binary.h"
#include "streams/Reflection.h"
#include "streams/Type.h"

namespace gt {

/// The id of a message type. Every reflected type is a message type and needs no registration.
template <typename T>
constexpr std::uint32_t messageId() {
  return hashOf(typeName<T>());
}
/// An id for messages that are written by streams and have no C++ type (MessageStreams.h).
constexpr std::uint32_t messageId(std::string_view name) {
  return hashOf(name);
}

/// A message in a queue. The bytes belong to the queue and are valid until the queue is changed.
struct Message {
  std::uint32_t id;
  Time time;
  std::span<const std::byte> bytes;

  template <typename T>
  bool is() const {
    return id == messageId<T>();
  }
  /// Reads the message. Can be called repeatedly (the report's resetReadPosition is not needed).
  /// The message may come from outside: values that its type does not allow are an error
  /// (`checked`).
  template <typename T>
  Result<void> read(T& value) const {
    auto done = decode(bytes, value);
    return done ? checked(valueOf(std::as_const(value))) : done;
  }
};

/// Number of dropped messages of one type.
struct DroppedMessage {
  std::uint32_t id = 0;
  std::string type;
  std::uint64_t count = 0;

  static constexpr auto fields() {
    return Fields{field<&DroppedMessage::id>("message id; 0: sum of all further types"),
                  field<&DroppedMessage::type>("name of the type; empty if only the id is known"),
                  field<&DroppedMessage::count>()};
  }
};

/// Counts the messages for which a queue had no room. Written by the queue itself, see
/// MessageQueue::reportDropped.
struct DroppedMessages {
  std::vector<DroppedMessage> types;

  static constexpr auto fields() { return Fields{field<&DroppedMessages::types>()}; }
};

/// A list of messages of any types with their time stamps, in a block of memory that is allocated
/// once (report E.1). If it overflows, it drops the message and counts the drop by its type,
/// whereas the report's robot crashed.
class MessageQueue {
 public:
  explicit MessageQueue(std::size_t capacity = 1 << 20);
  MessageQueue(const MessageQueue& other);
  MessageQueue(MessageQueue&& other) noexcept;
  /// Copies the messages of another queue; this queue keeps its own memory.
  MessageQueue& operator=(const MessageQueue& other);
  MessageQueue& operator=(MessageQueue&& other) noexcept;
  ~MessageQueue() = default;

  /// Appends a message. If the queue is full, returns false and counts the drop.
  template <typename T>
  bool write(Time time, const T& value) {
    std::byte* place = reserve(messageId<T>(), typeName<T>(), time, encodedSize(value));
    if (place) encodeTo(value, place);
    return place != nullptr;
  }
  bool append(const Message& message);
  /// Appends a message of a size (bytes) and returns the place for its bytes. If the queue is full,
  /// returns null and counts the drop.
  std::byte* reserve(std::uint32_t id, std::string_view type, Time time, std::size_t size);

  /// Copies or moves messages to the end of another queue: all messages, or those of one id.
  void copyAllMessages(MessageQueue& to) const;
  void copyMessages(std::uint32_t id, MessageQueue& to) const;
  void moveAllMessages(MessageQueue& to);
  void moveMessages(std::uint32_t id, MessageQueue& to);
  void clear() { size_ = 0; }

  bool empty() const { return size_ == 0; }
  /// Size of all messages, in bytes.
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  /// Number of messages dropped since the last report.
  std::uint64_t dropped() const;
  /// If messages were dropped, appends a message with their number by type and resets the counters.
  /// If the queue has no room for the report, it stays pending.
  void reportDropped(Time now);

  /// Calls handler(message) for each message, the oldest first.
  template <typename Handler>
  void handleAllMessages(Handler&& handler) const {
    for (std::size_t at = 0; at < size_;) {
      const Message message = messageAt(at);
      handler(message);
      at += headerSize + message.bytes.size();
    }
  }
  /// Removes the messages for which condition(message) is true. The condition is checked for the
  /// oldest message first.
  template <typename Condition>
  void removeIf(Condition&& condition) {
    std::size_t end = 0;
    for (std::size_t at = 0; at < size_;) {
      const Message message = messageAt(at);
      const std::size_t size = headerSize + message.bytes.size();
      if (!condition(message)) {
        if (end < at) std::memmove(&bytes_[end], &bytes_[at], size);
        end += size;
      }
      at += size;
    }
    size_ = end;
  }

  /// The queue as bytes, for transmission. `assign` restores a queue from bytes; it rejects bytes
  /// that are not a queue, or exceed the capacity.
  std::span<const std::byte> bytes() const { return {bytes_.get(), size_}; }
  bool assign(std::span<const std::byte> bytes);

 private:
  struct Dropped {
    std::uint32_t id = 0;
    std::string_view type;
    std::uint64_t count = 0;
  };
  static constexpr std::size_t headerSize = 16;  // id, size, time

  void countDropped(std::uint32_t id, std::string_view type);
  Message messageAt(std::size_t at) const;

  std::size_t capacity_;
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
  /// In the order of their first drop; the last entry counts all further types.
  std::array<Dropped, 16> dropped_;
  bool anyDropped_ = false;
};

}  // namespace gt
