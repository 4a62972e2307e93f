#include "streams/MessageQueue.h"

#include <cstring>

namespace gt {

std::size_t MessageQueue::open(std::uint32_t id, Time time) {
  const std::size_t begin = bytes_.size();
  bytes_.resize(begin + headerSize);
  std::memcpy(&bytes_[begin], &id, 4);
  std::memcpy(&bytes_[begin + 8], &time.ms, 8);
  return begin;
}

bool MessageQueue::close(std::size_t begin) {
  if (bytes_.size() > capacity_) {
    bytes_.resize(begin);
    ++dropped_;
    return false;
  }
  const auto size = static_cast<std::uint32_t>(bytes_.size() - begin - headerSize);
  std::memcpy(&bytes_[begin + 4], &size, 4);
  return true;
}

bool MessageQueue::append(const Message& message) {
  const std::size_t begin = open(message.id, message.time);
  bytes_.insert(bytes_.end(), message.bytes.begin(), message.bytes.end());
  return close(begin);
}

void MessageQueue::copyAllMessages(MessageQueue& to) const {
  handleAllMessages([&](const Message& message) { to.append(message); });
}

void MessageQueue::moveAllMessages(MessageQueue& to) {
  if (to.empty() && bytes_.size() <= to.capacity_)
    bytes_.swap(to.bytes_);
  else
    copyAllMessages(to);
  clear();
}

void MessageQueue::clear() {
  bytes_.clear();
}

Message MessageQueue::messageAt(std::size_t at) const {
  Message message{};
  std::uint32_t size;
  std::memcpy(&message.id, &bytes_[at], 4);
  std::memcpy(&size, &bytes_[at + 4], 4);
  std::memcpy(&message.time.ms, &bytes_[at + 8], 8);
  message.bytes = std::span{bytes_}.subspan(at + headerSize, size);
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
  bytes_.assign(bytes.begin(), bytes.end());
  return true;
}

}  // namespace gt
