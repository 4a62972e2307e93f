#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "base/Enum.h"
#include "streams/MessageQueue.h"

namespace gt {

/// How the queue to the tools is filled, named as in report I. Report E.3 calls `queue`
/// immediately, and `replace` real time.
enum class QueueFillMode { queue, replace, reject, collect, save };

/// Asks the Debug process to change how the queue to the tools is filled (report E.3, I: `qfr`).
struct QueueFillRequest {
  QueueFillMode mode = QueueFillMode::queue;
  double seconds = 0;

  static constexpr auto fields() {
    return Fields{
        field<&QueueFillRequest::mode>(),
        field<&QueueFillRequest::seconds>(Unit::s, "duration of collect and save", {0, 86400})};
  }
};

/// Keeps the newest messages only (report E.3: real time): a message replaces older ones of its
/// kind. A drawing that consists of several messages is kept completely, and does not replace
/// drawings of other keys.
class NewestMessages {
 public:
  /// Appends the messages of a queue to another one, from which replaced messages are removed.
  void append(const MessageQueue& messages, MessageQueue& to);

 private:
  /// The newest message of a kind.
  struct Newest {
    std::uint64_t kind;
    Time time;
    const std::byte* message;
  };

  const Newest* find(std::uint64_t kind) const;
  bool isReplaced(const Message& message) const;

  std::vector<Newest> newest_;
};

/// Fills the queue to the tools as the last request demands:
/// - queue: with all messages; what does not fit is dropped, and that is reported;
/// - replace: with the newest messages (NewestMessages), here and in the queue of each tool;
/// - reject: not at all;
/// - collect: with all messages for some seconds, then not at all;
/// - save: not at all; the messages of some seconds go to whoever saves them.
/// Answers to requests come in any case.
class QueueFill {
 public:
  using Saver = std::function<void(const MessageQueue&)>;

  /// Sets the receiver of the messages that were collected to be saved.
  void onSave(Saver saver) { saver_ = std::move(saver); }
  /// Returns false if the duration is invalid.
  bool request(const QueueFillRequest& request, Time now);
  /// Ends a timed request whose time is over. Must be called before messages are taken.
  void update(Time now);
  void take(const MessageQueue& messages, MessageQueue& toTools);

 private:
  QueueFillRequest request_;
  Time end_;
  Saver saver_;
  MessageQueue saved_{16 << 20};
  NewestMessages newest_;
};

}  // namespace gt
