#include "streams/MessageQueue.h"

#include <cstring>
#include <limits>
#include <utility>

namespace gt {

// Memory that nobody has written to yet costs nothing, so it is not cleared.
MessageQueue::MessageQueue(std::size_t capacity)
    : capacity_{capacity}, bytes_{new std::byte[capacity]} {}

MessageQueue::MessageQueue(const MessageQueue& other) : MessageQueue{other.capacity_} {
  *this = other;
}

MessageQueue::MessageQueue(MessageQueue&& other) noexcept : capacity_{0} {
  *this = std::move(other);
}

MessageQueue& MessageQueue::operator=(const MessageQueue& other) {
  if (this == &other) return *this;
  clear();
  other.copyAllMessages(*this);
  return *this;
}

MessageQueue& MessageQueue::operator=(MessageQueue&& other) noexcept {
  std::swap(capacity_, other.capacity_);
  std::swap(bytes_, other.bytes_);
  std::swap(size_, other.size_);
  std::swap(dropped_, other.dropped_);
  std::swap(anyDropped_, other.anyDropped_);
  return *this;
}

std::byte* MessageQueue::reserve(std::uint32_t id, std::string_view type, Time time,
                                 std::size_t size) {
  const std::size_t room = capacity_ - size_;
  if (room < headerSize || room - headerSize < size ||
      size > std::numeric_limits<std::uint32_t>::max()) {
    countDropped(id, type);
    return nullptr;
  }
  std::byte* header = &bytes_[size_];
  const auto size32 = static_cast<std::uint32_t>(size);
  std::memcpy(header, &id, 4);
  std::memcpy(header + 4, &size32, 4);
  std::memcpy(header + 8, &time.ms, 8);
  size_ += headerSize + size;
  return header + headerSize;
}

bool MessageQueue::append(const Message& message) {
  std::byte* place = reserve(message.id, {}, message.time, message.bytes.size());
  if (place && !message.bytes.empty())
    std::memcpy(place, message.bytes.data(), message.bytes.size());
  return place != nullptr;
}

void MessageQueue::copyAllMessages(MessageQueue& to) const {
  if (size_ <= to.capacity_ - to.size_) {
    if (size_ > 0) std::memcpy(&to.bytes_[to.size_], bytes_.get(), size_);
    to.size_ += size_;
  } else
    handleAllMessages([&](const Message& message) { to.append(message); });
}

void MessageQueue::copyMessages(std::uint32_t id, MessageQueue& to) const {
  handleAllMessages([&](const Message& message) {
    if (message.id == id) to.append(message);
  });
}

void MessageQueue::moveAllMessages(MessageQueue& to) {
  if (this == &to) return;
  if (to.empty() && to.capacity_ == capacity_) {
    bytes_.swap(to.bytes_);
    std::swap(size_, to.size_);
  } else
    copyAllMessages(to);
  clear();
}

void MessageQueue::moveMessages(std::uint32_t id, MessageQueue& to) {
  if (this == &to) return;
  copyMessages(id, to);
  removeIf([&](const Message& message) { return message.id == id; });
}

std::uint64_t MessageQueue::dropped() const {
  std::uint64_t sum = 0;
  for (const Dropped& dropped : dropped_) sum += dropped.count;
  return sum;
}

void MessageQueue::countDropped(std::uint32_t id, std::string_view type) {
  anyDropped_ = true;
  for (Dropped& dropped : dropped_) {
    if (&dropped != &dropped_.back()) {
      if (dropped.count > 0 && dropped.id != id) continue;
      dropped.id = id;
      if (!type.empty()) dropped.type = type;
    }
    ++dropped.count;
    return;
  }
}

void MessageQueue::reportDropped(Time now) {
  if (!anyDropped_) return;
  DroppedMessages message;
  for (const Dropped& dropped : dropped_)
    if (dropped.count > 0)
      message.types.push_back({dropped.id, std::string{dropped.type}, dropped.count});
  const std::size_t size = encodedSize(message);
  if (capacity_ - size_ < headerSize || capacity_ - size_ - headerSize < size) return;
  write(now, message);
  dropped_ = {};
  anyDropped_ = false;
}

Message MessageQueue::messageAt(std::size_t at) const {
  Message message{};
  std::uint32_t size;
  std::memcpy(&message.id, &bytes_[at], 4);
  std::memcpy(&size, &bytes_[at + 4], 4);
  std::memcpy(&message.time.ms, &bytes_[at + 8], 8);
  message.bytes = bytes().subspan(at + headerSize, size);
  return message;
}

bool MessageQueue::assign(std::span<const std::byte> bytes) {
  std::size_t at = 0;
  while (at < bytes.size()) {
    std::uint32_t size;
    if (bytes.size() - at < headerSize) return false;
    std::memcpy(&size, &bytes[at + 4], 4);
    if (bytes.size() - at - headerSize < size) return false;
    at += headerSize + size;
  }
  if (bytes.size() > capacity_) return false;
  if (!bytes.empty()) std::memmove(bytes_.get(), bytes.data(), bytes.size());
  size_ = bytes.size();
  return true;
}

}  // namespace gt
