#include "foxglove/WebSocketOutbox.h"

#include <iterator>
#include <utility>

namespace gt {
namespace {

/// A client is disconnected if so many times the bytes wait for it from which on messages are
/// dropped.
constexpr std::size_t muchMore = 16;

std::size_t sizeOf(const WebSocketMessage& message) {
  constexpr std::size_t beside = 128;
  return beside + message.head.size() + message.body->size();
}

}  // namespace

WebSocketOutbox::Outcome WebSocketOutbox::put(WebSocketMessage message, std::size_t mostWaiting) {
  if (bytes_ > muchMore * mostWaiting) return Outcome::full;
  const std::size_t size = sizeOf(message);
  if (const auto older = newest_.find(message.newestOf); older != newest_.end()) {
    bytes_ += size - sizeOf(*older->second);
    *older->second = std::move(message);
    return Outcome::dropped;
  }
  if (message.droppable && bytes_ > 0 && bytes_ + size > mostWaiting) {
    isFull_ = true;
    return Outcome::dropped;
  }
  bytes_ += size;
  if (message.urgent) {
    urgent_.push_back(std::move(message));
  } else {
    waiting_.push_back(std::move(message));
    if (waiting_.back().newestOf != 0)
      newest_[waiting_.back().newestOf] = std::prev(waiting_.end());
  }
  return std::exchange(isSending_, true) ? Outcome::waits : Outcome::first;
}

std::optional<WebSocketMessage> WebSocketOutbox::take() {
  bytes_ -= std::exchange(sending_, 0);
  isFull_ = false;
  isSending_ = !urgent_.empty() || !waiting_.empty();
  if (!isSending_) return {};
  WebSocketMessage message;
  if (!urgent_.empty()) {
    message = std::move(urgent_.front());
    urgent_.pop_front();
  } else {
    message = std::move(waiting_.front());
    waiting_.pop_front();
    newest_.erase(message.newestOf);
  }
  sending_ = sizeOf(message);
  return message;
}

}  // namespace gt
