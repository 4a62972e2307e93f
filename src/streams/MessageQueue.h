#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/Time.h"
#include "streams/Binary.h"
#include "streams/Reflection.h"

namespace gt {

/// The id under which messages of a type travel: every reflected type is a message type, nothing is
/// listed anywhere.
template <typename T>
constexpr std::uint32_t messageId() {
  return hashOf(typeName<T>());
}

/// One message as it lies in a queue. The bytes are the queue's and live as long as it is not
/// changed.
struct Message {
  std::uint32_t id;
  Time time;
  std::span<const std::byte> bytes;

  template <typename T>
  bool is() const {
    return id == messageId<T>();
  }
  /// Reads the message, as often as one likes (the report's resetReadPosition is not needed).
  template <typename T>
  Result<void> read(T& value) const {
    return decode(bytes, value);
  }
};

/// A list of messages of any types with their time stamps, in a bounded piece of memory (report
/// E.1). Where the report's robot crashed when a queue overflowed, this one drops the message and
/// counts it.
class MessageQueue {
 public:
  explicit MessageQueue(std::size_t capacity = 1 << 20) : capacity_{capacity} {}

  /// Appends a message; false if there was no room for it.
  template <typename T>
  bool write(Time time, const T& value) {
    const std::size_t begin = open(messageId<T>(), time);
    encode(value, bytes_);
    return close(begin);
  }
  bool append(const Message& message);
  void copyAllMessages(MessageQueue& to) const;
  void moveAllMessages(MessageQueue& to);
  void clear();

  bool empty() const { return bytes_.empty(); }
  std::size_t size() const { return bytes_.size(); }
  std::uint64_t dropped() const { return dropped_; }

  /// Calls handler(message) for each message, the oldest first.
  template <typename Handler>
  void handleAllMessages(Handler&& handler) const {
    for (std::size_t at = 0; at < bytes_.size();) {
      const Message message = messageAt(at);
      handler(message);
      at += headerSize + message.bytes.size();
    }
  }

  /// The queue as bytes, for a wire; `assign` takes them back and rejects what is not a queue.
  std::span<const std::byte> bytes() const { return bytes_; }
  bool assign(std::span<const std::byte> bytes);

 private:
  static constexpr std::size_t headerSize = 16;  // id, size, time

  std::size_t open(std::uint32_t id, Time time);
  bool close(std::size_t begin);
  Message messageAt(std::size_t at) const;

  std::vector<std::byte> bytes_;
  std::size_t capacity_;
  std::uint64_t dropped_ = 0;
};

}  // namespace gt
