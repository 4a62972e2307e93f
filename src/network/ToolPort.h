#pragma once
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "framework/QueueFill.h"
#include "network/Network.h"
#include "network/Vocabulary.h"
#include "streams/MessageQueue.h"

namespace gt {

/// Size (bytes) of the queue of messages to a tool, and of that from a tool.
constexpr std::size_t toolQueueSize = 2 << 20;

/// The port of a robot for tools. Each tool receives every message that the robot sends, and may
/// send messages. The memory for each tool is bounded: messages that a tool does not receive in
/// time are dropped for that tool, and a tool that sends without a request is ignored (report 5.3).
/// If requested by a QueueFillRequest, a slow tool only receives the newest messages. Both sides
/// state the vocabulary that they use for writing. An unknown vocabulary is requested before
/// messages are accepted.
class ToolPort {
 public:
  /// Opens the port. Without a vocabulary, messages are transferred unchanged.
  static Result<std::unique_ptr<ToolPort>> open(Network& network, const std::string& endpoint,
                                                const std::optional<Keys>& keys = {},
                                                const Vocabulary* vocabulary = nullptr);

  /// Sends messages to all tools.
  void send(const MessageQueue& messages);
  /// Appends the tools' messages to `messages`, and serves the tools' requests. Messages for which
  /// there is no room stay at the tools.
  void update(MessageQueue& messages);

  /// States that messages are written in another program's vocabulary from now on.
  void relay(const TypeDescriptions& types);
  /// News about the tools that were not yet reported to the user, including refused tools, once for
  /// each reason.
  std::vector<std::string> takeNews();

  std::size_t tools() const { return tools_.size(); }
  std::string endpoint() const { return socket_->endpoint(); }
  /// Number of messages that were dropped for a tool, and of invalid received messages.
  std::uint64_t dropped() const;
  std::uint64_t rejected() const { return rejected_ + socket_->rejected(); }
  /// The refused tools.
  Refusals refusals() const;

 private:
  struct Tool {
    std::string name, address;
    std::int64_t heard = 0;
    std::int64_t asked = -1;
    bool mayGet = false;   ///< Whether the tool requested a queue.
    bool maySend = false;  ///< Whether a queue was requested from the tool.
    MessageQueue out{toolQueueSize};
    Interpreter interpreter;
    std::int64_t wondered = -1;  ///< When the tool's vocabulary was requested.
  };

  ToolPort(Network& network, Socket& socket, const Vocabulary* vocabulary);
  Tool* find(const Received& received);
  void refuse(std::string_view name, Refusal reason);
  void take(const Received& received, MessageQueue& messages);
  void heed(const MessageQueue& requests);
  void serve(Tool& tool);

  Network& network_;
  Socket* socket_;
  const Vocabulary* vocabulary_;
  TypeDescriptions types_;  ///< Vocabulary of the messages to tools.
  Topic topic_;
  bool newestOnly_ = false;
  NewestMessages newest_;
  std::vector<std::unique_ptr<Tool>> tools_;
  std::uint64_t rejected_ = 0;
  Refusals refusals_;
  std::set<std::string, std::less<>> refused_;  ///< Names of refused tools, to count each once.
  EnumArray<Refusal, bool> reported_;
  std::uint64_t dropped_ = 0;  ///< Drops that were reported to the tools, or that belong to tools
                               ///< that are gone.
};

/// A tool's connection to a robot's port, or to the router's port for that robot.
class ToolConnection {
 public:
  /// Opens the connection. Without a vocabulary, messages are transferred unchanged.
  static Result<std::unique_ptr<ToolConnection>> open(Network& network, const std::string& endpoint,
                                                      const std::optional<Keys>& keys = {},
                                                      const Vocabulary* vocabulary = nullptr);

  /// Messages for the robot; they are sent when the robot requests them.
  MessageQueue& out() { return out_; }
  /// Appends the robot's messages to `messages`. Messages for which there is no room stay at the
  /// robot.
  void update(MessageQueue& messages);
  /// Whether data was received from the robot within the last second.
  bool connected() const { return heard_ >= 0 && network_.elapsed() - heard_ < 1000; }
  std::uint64_t rejected() const { return rejected_ + socket_->rejected(); }
  /// The vocabulary that the robot uses for writing, if it differs from the own one.
  const TypeDescriptions& theirs() const { return interpreter_.theirs(); }
  /// News about the robot that were not yet reported to the user.
  std::vector<std::string> takeNews() { return interpreter_.takeNews(); }
  /// Why the robot is not connected, if known; otherwise empty.
  std::string trouble() const { return connected() ? "" : socket_->trouble(); }

 private:
  ToolConnection(Network& network, Socket& socket, const Vocabulary* vocabulary);
  void take(const Frame& frame, MessageQueue& messages);

  Network& network_;
  Socket* socket_;
  const Vocabulary* vocabulary_;
  Topic topic_;
  Interpreter interpreter_;
  std::int64_t wondered_ = -1;
  bool understood_ = true;  ///< Whether the vocabulary of the last frame is known.
  std::int64_t heard_ = -1;
  std::int64_t asked_ = -1;
  bool maySend_ = false;
  MessageQueue out_{toolQueueSize};
  std::uint64_t rejected_ = 0;
};

}  // namespace gt
