#include "network/ToolPort.h"

#include <algorithm>

namespace gt {
namespace {

/// A tool that was not heard of for so long is gone, in ms.
constexpr std::int64_t lostAfter = 2000;
/// Requests are repeated, in ms.
constexpr std::int64_t repeatAfter = 100;
constexpr std::size_t mostTools = 32;
/// Of one address of IP, so that tools of other machines have places, too.
constexpr std::size_t mostToolsOfOne = 16;
/// What is taken in one go, so that a flood does not hold the robot up.
constexpr int framesPerUpdate = 64;
/// A frame holds a tool's queue at most; few wait, so a flood finds little room.
constexpr SocketLimits limits{8, static_cast<std::int64_t>(toolQueueSize + Frame::headerSize)};

/// What frames of queues are about, written by a vocabulary.
Topic queuesBy(std::uint32_t vocabulary) {
  Topic topic{representation<MessageQueue>()};
  topic.schema = vocabulary;
  return topic;
}

/// Takes a frame's queue; returns false if the frame has no valid one.
bool takeQueue(const Frame& frame, MessageQueue& queue) {
  return frame.type == messageId<MessageQueue>() && queue.assign(frame.bytes);
}

/// Takes the description of a vocabulary; false if the frame is another one.
bool takeTypes(const Frame& frame, Interpreter& interpreter) {
  TypeDescriptions types;
  if (frame.type != messageId<TypeDescriptions>() || !decode(frame.bytes, types)) return false;
  interpreter.learn(std::move(types));
  return true;
}

/// Whether it is time to report something again.
bool isDue(std::int64_t& last, std::int64_t now) {
  if (last >= 0 && now - last < repeatAfter) return false;
  last = now;
  return true;
}

/// A robot's queue is asked for only while a small part of the place for it is in use.
bool hasRoom(const MessageQueue& messages) {
  return messages.size() < toolQueueSize / 4;
}

}  // namespace

Result<std::unique_ptr<ToolPort>> ToolPort::open(Network& network, const std::string& endpoint,
                                                 const std::optional<Keys>& keys,
                                                 const Vocabulary* vocabulary) {
  const auto socket = network.listen(endpoint, keys, limits);
  if (!socket) return socket.error();
  return std::unique_ptr<ToolPort>{new ToolPort{network, **socket, vocabulary}};
}

ToolPort::ToolPort(Network& network, Socket& socket, const Vocabulary* vocabulary)
    : network_{network},
      socket_{&socket},
      vocabulary_{vocabulary},
      types_{vocabulary ? vocabulary->descriptions() : TypeDescriptions{}},
      topic_{queuesBy(types_.vocabulary)} {}

void ToolPort::relay(const TypeDescriptions& types) {
  if (types.vocabulary == types_.vocabulary) return;
  types_ = types;
  topic_ = queuesBy(types.vocabulary);
}

std::vector<std::string> ToolPort::takeNews() {
  std::vector<std::string> news;
  for (const auto& tool : tools_)
    for (const std::string& line : tool->interpreter.takeNews()) news.push_back("a tool: " + line);
  const Refusals refused = refusals();
  for (std::size_t i = 0; i < enumCount<Refusal>; ++i) {
    const auto reason = static_cast<Refusal>(i);
    // Who looks for robots connects and sends nothing.
    if (reason == Refusal::silent || refused[reason] == 0 || reported_[reason]) continue;
    reported_[reason] = true;
    news.push_back("a tool is not let in: " + std::string{describe(reason)});
  }
  return news;
}

Refusals ToolPort::refusals() const {
  Refusals sum = refusals_;
  for (std::size_t i = 0; i < sum.size(); ++i) sum.values[i] += socket_->refusals().values[i];
  return sum;
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

ToolPort::Tool* ToolPort::find(const Received& received) {
  std::size_t ofOne = 0;
  for (const auto& tool : tools_) {
    if (tool->name == received.peer) return tool.get();
    ofOne += !received.address.empty() && tool->address == received.address;
  }
  const bool isMuch = ofOne >= mostToolsOfOne;
  if (isMuch || tools_.size() >= mostTools) {
    refuse(received.peer, isMuch ? Refusal::share : Refusal::noPlace);
    return nullptr;
  }
  return tools_
      .emplace_back(std::make_unique<Tool>(Tool{.name = std::string{received.peer},
                                                .address = std::string{received.address},
                                                .interpreter = Interpreter{vocabulary_}}))
      .get();
}

void ToolPort::refuse(std::string_view name, Refusal reason) {
  if (refused_.contains(name)) return;
  if (refused_.size() >= mostTools) refused_.clear();
  refused_.emplace(name);
  ++refusals_[reason];
}

void ToolPort::take(const Received& received, MessageQueue& messages) {
  Tool* tool = find(received);
  if (!tool) {
    ++rejected_;
    return;
  }
  tool->heard = network_.elapsed();
  const Frame& frame = received.frame;
  if (frame.kind == FrameKind::describe) {
    socket_->send(tool->name, FrameKind::package, representation<TypeDescriptions>(), &types_);
    return;
  }
  if (frame.kind != FrameKind::package) {
    tool->mayGet = true;
    if (vocabulary_ && !tool->interpreter.knows(frame.schema) &&
        isDue(tool->wondered, network_.elapsed()))
      socket_->send(tool->name, FrameKind::describe, topic_, nullptr);
    return;
  }
  if (takeTypes(frame, tool->interpreter)) return;
  MessageQueue queue{toolQueueSize};
  // One that is not understood yet is asked for its vocabulary when it asks for messages.
  const bool understood = !vocabulary_ || tool->interpreter.knows(frame.schema);
  if (!tool->maySend || !understood || !takeQueue(frame, queue)) {
    ++rejected_;
    return;
  }
  tool->maySend = false;
  tool->asked = -1;
  heed(queue);
  tool->interpreter.take(queue, messages);  // there is room: it was asked for
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
    socket_->send(tool.name, FrameKind::package, topic_, &tool.out);
    tool.out.clear();
    tool.mayGet = false;
    dropped_ += tool.out.dropped();
    tool.out.reportDropped(network_.now);
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
    // One tool at a time may fill what is left, and each is notified that the robot is there.
    if (!hasRoom(messages) || !isDue(tool->asked, now)) continue;
    socket_->send(tool->name, FrameKind::request, topic_, nullptr);
    tool->maySend = true;
  }
}

Result<std::unique_ptr<ToolConnection>> ToolConnection::open(Network& network,
                                                             const std::string& endpoint,
                                                             const std::optional<Keys>& keys,
                                                             const Vocabulary* vocabulary) {
  const auto socket = network.connect(endpoint, "", keys, limits);
  if (!socket) return socket.error();
  return std::unique_ptr<ToolConnection>{new ToolConnection{network, **socket, vocabulary}};
}

ToolConnection::ToolConnection(Network& network, Socket& socket, const Vocabulary* vocabulary)
    : network_{network},
      socket_{&socket},
      vocabulary_{vocabulary},
      topic_{queuesBy(vocabulary ? vocabulary->id() : 0)},
      interpreter_{vocabulary} {}

void ToolConnection::take(const Frame& frame, MessageQueue& messages) {
  if (frame.kind == FrameKind::describe) {
    if (vocabulary_)
      socket_->send("", FrameKind::package, representation<TypeDescriptions>(),
                    &vocabulary_->descriptions());
    return;
  }
  if (frame.kind == FrameKind::package && takeTypes(frame, interpreter_)) return;
  understood_ = interpreter_.knows(frame.schema);
  if (frame.kind != FrameKind::package) {
    maySend_ = true;
    return;
  }
  MessageQueue queue{toolQueueSize};
  if ((vocabulary_ && !understood_) || !takeQueue(frame, queue)) {
    ++rejected_;
    return;
  }
  interpreter_.take(queue, messages);  // there is room: it was asked for
  asked_ = -1;
}

void ToolConnection::update(MessageQueue& messages) {
  Received received;
  for (int i = 0; i < framesPerUpdate && socket_->receive(received); ++i) {
    heard_ = network_.elapsed();
    take(received.frame, messages);
  }
  if (maySend_ && !out_.empty()) {
    socket_->send("", FrameKind::package, topic_, &out_);
    out_.clear();
    maySend_ = false;
  }
  const std::int64_t now = network_.elapsed();
  if (!understood_ && isDue(wondered_, now))
    socket_->send("", FrameKind::describe, topic_, nullptr);
  if (!hasRoom(messages) || (asked_ >= 0 && now - asked_ < repeatAfter)) return;
  if (socket_->send("", FrameKind::request, topic_, nullptr)) asked_ = now;
}

}  // namespace gt
