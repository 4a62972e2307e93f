#include "network/ToolPort.h"

#include <algorithm>

namespace gt {
namespace {

/// A tool that was not heard of for so long is gone, in ms.
constexpr std::int64_t lostAfter = 2000;
/// Requests are repeated, in ms.
constexpr std::int64_t repeatAfter = 100;
constexpr std::size_t mostTools = 32;
/// What is taken in one go, so that a flood does not hold the robot up.
constexpr int framesPerUpdate = 64;
/// A frame holds a tool's queue at most; few wait, so a flood finds little room.
constexpr SocketLimits limits{8, static_cast<std::int64_t>(toolQueueSize + Frame::headerSize)};

const Topic& queues() {
  static const Topic topic{representation<MessageQueue>()};
  return topic;
}

/// Takes a frame's queue; false if it is none.
bool takeQueue(const Frame& frame, MessageQueue& queue) {
  return frame.type == queues().type->id && queue.assign(frame.bytes);
}

/// A robot's queue is asked for only while a small part of the place for it is in use.
bool hasRoom(const MessageQueue& messages) {
  return messages.size() < toolQueueSize / 4;
}

}  // namespace

Result<std::unique_ptr<ToolPort>> ToolPort::open(Network& network, const std::string& endpoint,
                                                 const std::optional<Keys>& keys) {
  const auto socket = network.listen(endpoint, keys, limits);
  if (!socket) return socket.error();
  return std::unique_ptr<ToolPort>{new ToolPort{network, **socket}};
}

void ToolPort::send(const MessageQueue& messages) {
  for (const auto& tool : tools_)
    if (newestOnly_)
      newest_.append(messages, tool->out);
    else
      messages.copyAllMessages(tool->out);
}

std::uint64_t ToolPort::dropped() const {
  std::uint64_t sum = dropped_;
  for (const auto& tool : tools_) sum += tool->out.dropped();
  return sum;
}

ToolPort::Tool* ToolPort::find(std::string_view name) {
  for (const auto& tool : tools_)
    if (tool->name == name) return tool.get();
  if (tools_.size() >= mostTools) return nullptr;
  return tools_.emplace_back(std::make_unique<Tool>(Tool{.name = std::string{name}})).get();
}

void ToolPort::take(const Received& received, MessageQueue& messages) {
  Tool* tool = find(received.peer);
  if (!tool) {
    ++rejected_;
    return;
  }
  tool->heard = network_.elapsed();
  if (received.frame.kind != FrameKind::package) {
    tool->mayGet = true;
    return;
  }
  MessageQueue queue{toolQueueSize};
  if (!tool->maySend || !takeQueue(received.frame, queue)) {
    ++rejected_;
    return;
  }
  tool->maySend = false;
  tool->asked = -1;
  heed(queue);
  queue.moveAllMessages(messages);  // there is room: it was asked for
}

/// What the robot was asked to do with its queue holds for the tools' queues, too.
void ToolPort::heed(const MessageQueue& requests) {
  requests.handleAllMessages([this](const Message& message) {
    QueueFillRequest wanted;
    if (message.is<QueueFillRequest>() && message.read(wanted))
      newestOnly_ = wanted.mode == QueueFillMode::replace;
  });
}

void ToolPort::serve(Tool& tool) {
  if (tool.mayGet && !tool.out.empty()) {
    socket_->send(tool.name, FrameKind::package, queues(), &tool.out);
    tool.out.clear();
    tool.mayGet = false;
    dropped_ += tool.out.dropped();
    tool.out.tellDropped(network_.now);
  }
}

void ToolPort::update(MessageQueue& messages) {
  Received received;
  for (int i = 0; i < framesPerUpdate && socket_->receive(received); ++i) take(received, messages);
  const std::int64_t now = network_.elapsed();
  std::erase_if(tools_, [&](const auto& tool) {
    const bool gone = now - tool->heard >= lostAfter;
    if (gone) dropped_ += tool->out.dropped();
    return gone;
  });
  for (const auto& tool : tools_) {
    serve(*tool);
    // One tool at a time may fill what is left, and each is told that the robot is there.
    if (!hasRoom(messages) || (tool->asked >= 0 && now - tool->asked < repeatAfter)) continue;
    socket_->send(tool->name, FrameKind::request, queues(), nullptr);
    tool->maySend = true;
    tool->asked = now;
  }
}

Result<std::unique_ptr<ToolConnection>> ToolConnection::open(Network& network,
                                                             const std::string& endpoint,
                                                             const std::optional<Keys>& keys) {
  const auto socket = network.connect(endpoint, "", keys, limits);
  if (!socket) return socket.error();
  return std::unique_ptr<ToolConnection>{new ToolConnection{network, **socket}};
}

void ToolConnection::update(MessageQueue& messages) {
  Received received;
  MessageQueue queue{toolQueueSize};
  for (int i = 0; i < framesPerUpdate && socket_->receive(received); ++i) {
    heard_ = network_.elapsed();
    if (received.frame.kind != FrameKind::package) {
      maySend_ = true;
    } else if (takeQueue(received.frame, queue)) {
      queue.moveAllMessages(messages);  // there is room: it was asked for
      asked_ = -1;
    } else {
      ++rejected_;
    }
  }
  if (maySend_ && !out_.empty()) {
    socket_->send("", FrameKind::package, queues(), &out_);
    out_.clear();
    maySend_ = false;
  }
  const std::int64_t now = network_.elapsed();
  if (!hasRoom(messages) || (asked_ >= 0 && now - asked_ < repeatAfter)) return;
  if (socket_->send("", FrameKind::request, queues(), nullptr)) asked_ = now;
}

}  // namespace gt
