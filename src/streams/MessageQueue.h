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

/// The id under which messages of a type travel: every reflected type is a message type, nothing is
/// listed anywhere.
template <typename T>
constexpr std::uint32_t messageId() {
  return hashOf(typeName<T>());
}
/// An id for messages that are written by streams and have no type (MessageStreams.h).
constexpr std::uint32_t messageId(std::string_view name) {
  return hashOf(name);
}

/// One message as it lies in a queue. The bytes are the queue's and stay valid as long as it is not
/// changed.
struct Message {
  std::uint32_t id;
  Time time;
  std::span<const std::byte> bytes;

  template <typename T>
  bool is() const {
    return id == messageId<T>();
  }
  /// Reads the message, as often as one likes (the report's resetReadPosition is not needed). It
  /// may come from outside: what its type does not allow is an error (`checked`).
  template <typename T>
  Result<void> read(T& value) const {
    auto done = decode(bytes, value);
    return done ? checked(valueOf(std::as_const(value))) : done;
  }
};

/// How many messages of one type were dropped.
struct DroppedMessage {
  std::uint32_t id = 0;
  std::string type;
  std::uint64_t count = 0;

  static constexpr auto fields() {
    return Fields{field<&DroppedMessage::id>("0: of all further types"),
                  field<&DroppedMessage::type>("empty if only the id is known"),
                  field<&DroppedMessage::count>()};
  }
};

/// Counts what a queue had no room for. Written by the queue itself, see
/// MessageQueue::reportDropped.
struct DroppedMessages {
  std::vector<DroppedMessage> types;

  static constexpr auto fields() { return Fields{field<&DroppedMessages::types>()}; }
};

/// A list of messages of any types with their time stamps, in a piece of memory that is allocated
/// once (report E.1). Where the report's robot crashed when a queue overflowed, this one drops the
/// message and counts it by its type.
class MessageQueue {
 public:
  explicit MessageQueue(std::size_t capacity = 1 << 20);
  MessageQueue(const MessageQueue& other);
  MessageQueue(MessageQueue&& other) noexcept;
  /// Takes the other's messages; the queue keeps its own memory.
  MessageQueue& operator=(const MessageQueue& other);
  MessageQueue& operator=(MessageQueue&& other) noexcept;
  ~MessageQueue() = default;

  /// Appends a message; false if there was no room for it.
  template <typename T>
  bool write(Time time, const T& value) {
    std::byte* place = reserve(messageId<T>(), typeName<T>(), time, encodedSize(value));
    if (place) encodeTo(value, place);
    return place != nullptr;
  }
  bool append(const Message& message);
  /// Appends a message of a size and returns the place for its bytes. If the queue is full, returns
  /// null and counts the drop.
  std::byte* reserve(std::uint32_t id, std::string_view type, Time time, std::size_t size);

  /// Copies and moves messages to the end of another queue: all of them, or those of one id.
  void copyAllMessages(MessageQueue& to) const;
  void copyMessages(std::uint32_t id, MessageQueue& to) const;
  void moveAllMessages(MessageQueue& to);
  void moveMessages(std::uint32_t id, MessageQueue& to);
  void clear() { size_ = 0; }

  bool empty() const { return size_ == 0; }
  /// In bytes.
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  /// How many messages there was no room for since the last report.
  std::uint64_t dropped() const;
  /// If messages were dropped, appends a message that states how many of which types, and begins to
  /// count anew. It stays pending while there is no room for it either.
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
  /// Removes the messages for which condition(message) is true; it is asked for the oldest first.
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

  /// The queue as bytes, for a wire; `assign` takes them back and rejects what is not a queue, or
  /// larger than this one can be.
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
  /// In the order in which the types were dropped first; the last entry is for all further ones.
  std::array<Dropped, 16> dropped_;
  bool anyDropped_ = false;
};

}  // namespace gt
