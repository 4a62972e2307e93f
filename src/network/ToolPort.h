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

/// How much is kept for a tool, or from it, at a time.
constexpr std::size_t toolQueueSize = 2 << 20;

/// Where tools connect to a robot: each gets every message that the robot sends, and may send
/// messages. Memory is bounded for each tool: what one does not take in time is dropped for that
/// one, and one that sends without being asked is not listened to (report 5.3). A tool that takes
/// what was kept for it late gets the newest only, if the queues were asked to be filled so
/// (QueueFillRequest). Both sides state by which vocabulary they write, and ask for one that they
/// do not know before they take messages.
class ToolPort {
 public:
  /// Without a vocabulary messages are passed on as they are.
  static Result<std::unique_ptr<ToolPort>> open(Network& network, const std::string& endpoint,
                                                const std::optional<Keys>& keys = {},
                                                const Vocabulary* vocabulary = nullptr);

  /// Passes messages to all tools.
  void send(const MessageQueue& messages);
  /// Takes what tools sent to `messages`, and serves tools that ask. What has no room there is left
  /// with the tools.
  void update(MessageQueue& messages);

  /// From now on the messages are written by another program's vocabulary.
  void relay(const TypeDescriptions& types);
  /// News about the tools that was not yet reported to the user; also who was not let in, once for
  /// each reason.
  std::vector<std::string> takeNews();

  std::size_t tools() const { return tools_.size(); }
  std::string endpoint() const { return socket_->endpoint(); }
  /// Messages that did not fit for some tool, and what came in that was none.
  std::uint64_t dropped() const;
  std::uint64_t rejected() const { return rejected_ + socket_->rejected(); }
  /// Tools that were not let in.
  Refusals refusals() const;

 private:
  struct Tool {
    std::string name, address;
    std::int64_t heard = 0;
    std::int64_t asked = -1;
    bool mayGet = false;   ///< It requested a queue.
    bool maySend = false;  ///< It was asked for a queue.
    MessageQueue out{toolQueueSize};
    Interpreter interpreter;
    std::int64_t wondered = -1;  ///< When it was asked for its vocabulary.
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
  TypeDescriptions types_;  ///< By which messages to tools are written.
  Topic topic_;
  bool newestOnly_ = false;
  NewestMessages newest_;
  std::vector<std::unique_ptr<Tool>> tools_;
  std::uint64_t rejected_ = 0;
  Refusals refusals_;
  std::set<std::string, std::less<>> refused_;  ///< Names of those, to count each once.
  EnumArray<Refusal, bool> reported_;
  std::uint64_t dropped_ = 0;  ///< That were reported to the tools, or that are gone with them.
};

/// A tool's end: connects to a robot's port, or to the router's for that robot.
class ToolConnection {
 public:
  /// Without a vocabulary messages are passed on as they are.
  static Result<std::unique_ptr<ToolConnection>> open(Network& network, const std::string& endpoint,
                                                      const std::optional<Keys>& keys = {},
                                                      const Vocabulary* vocabulary = nullptr);

  /// Messages for the robot; they leave when it asks for them.
  MessageQueue& out() { return out_; }
  /// Takes what the robot sent to `messages`. What has no room there is left with the robot.
  void update(MessageQueue& messages);
  /// Something came from the robot within the last second.
  bool connected() const { return heard_ >= 0 && network_.elapsed() - heard_ < 1000; }
  std::uint64_t rejected() const { return rejected_ + socket_->rejected(); }
  /// The vocabulary by which the robot writes, as far as it is another one.
  const TypeDescriptions& theirs() const { return interpreter_.theirs(); }
  /// News about the robot that was not yet reported to the user.
  std::vector<std::string> takeNews() { return interpreter_.takeNews(); }
  /// Why the robot is not reached, as far as it is known; empty otherwise.
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
  bool understood_ = true;  ///< The vocabulary of the last frame is known.
  std::int64_t heard_ = -1;
  std::int64_t asked_ = -1;
  bool maySend_ = false;
  MessageQueue out_{toolQueueSize};
  std::uint64_t rejected_ = 0;
};

}  // namespace gt
