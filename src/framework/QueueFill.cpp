#include "framework/QueueFill.h"

#include <algorithm>
#include <cmath>

#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/Requests.h"

namespace gt {
namespace {

/// Answers to single requests are always sent.
bool isAnswer(const Message& message) {
  return message.is<RequestAnswer>() || message.is<ProcessDescription>() ||
         message.is<ModuleTimes>();
}

/// Messages of the same kind replace each other. Drawings and plots are of the same kind if they
/// have the same key, with which their bytes begin; other messages, if they have the same type.
/// Returns 0 for messages that are never replaced.
std::uint64_t messageKind(const Message& message) {
  if (message.is<DroppedMessages>() || isAnswer(message)) return 0;
  std::uint32_t key = 0;
  if (message.is<Drawing>() || message.is<Plot>()) {
    constexpr std::size_t begin = cdr::headerSize + sizeof(std::uint32_t);
    std::uint32_t length = 0;
    if (message.bytes.size() < begin) return 0;
    std::memcpy(&length, &message.bytes[cdr::headerSize], sizeof length);
    if (length > message.bytes.size() - begin) return 0;
    key = hashOf({reinterpret_cast<const char*>(message.bytes.data()) + begin, length});
  }
  return std::uint64_t{key} << 32 | message.id;
}

}  // namespace

bool QueueFill::request(const QueueFillRequest& request, Time now) {
  const bool timed = request.mode == QueueFillMode::collect || request.mode == QueueFillMode::save;
  if (timed && !(request.seconds > 0 && request.seconds <= 86400)) return false;
  request_ = request;
  saved_.clear();
  if (timed) end_ = now + std::llround(request.seconds * 1000);
  return true;
}

void QueueFill::update(Time now) {
  const bool saves = request_.mode == QueueFillMode::save;
  if ((!saves && request_.mode != QueueFillMode::collect) || now < end_) return;
  request_.mode = QueueFillMode::reject;
  if (!saves) return;
  saved_.reportDropped(now);
  if (saver_) saver_(saved_);
  saved_.clear();
}

void QueueFill::take(const MessageQueue& messages, MessageQueue& toTools) {
  switch (request_.mode) {
    case QueueFillMode::queue:
    case QueueFillMode::collect:
      return messages.copyAllMessages(toTools);
    case QueueFillMode::replace:
      return newest_.append(messages, toTools);
    case QueueFillMode::save:
      messages.copyAllMessages(saved_);
      [[fallthrough]];
    case QueueFillMode::reject:
      messages.handleAllMessages([&](const Message& message) {
        if (isAnswer(message)) toTools.append(message);
      });
      return;
  }
}

const NewestMessages::Newest* NewestMessages::find(std::uint64_t kind) const {
  const auto newest =
      std::find_if(newest_.begin(), newest_.end(), [&](const Newest& n) { return n.kind == kind; });
  return newest == newest_.end() ? nullptr : &*newest;
}

bool NewestMessages::isReplaced(const Message& message) const {
  const Newest* newest = find(messageKind(message));
  if (!newest || newest->message == message.bytes.data()) return false;
  return !message.is<Drawing>() || message.time != newest->time;
}

void NewestMessages::append(const MessageQueue& messages, MessageQueue& to) {
  newest_.clear();
  messages.handleAllMessages([&](const Message& message) {
    const std::uint64_t kind = messageKind(message);
    if (kind == 0) return;
    if (const Newest* known = find(kind))
      newest_[static_cast<std::size_t>(known - newest_.data())] = {kind, message.time,
                                                                   message.bytes.data()};
    else
      newest_.push_back({kind, message.time, message.bytes.data()});
  });
  to.removeIf([&](const Message& message) { return isReplaced(message); });
  messages.handleAllMessages([&](const Message& message) {
    if (!isReplaced(message)) to.append(message);
  });
}

}  // namespace gt
