#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "base/Enum.h"
#include "streams/MessageQueue.h"

namespace gt {

/// How the queue to the tools is filled, by the names of report I. `queue` is what report E.3 calls
/// immediately, `replace` what it calls real time.
enum class QueueFillMode { queue, replace, reject, collect, save };

/// Asks the Debug process to fill the queue to the tools in another way (report E.3, I: `qfr`).
struct QueueFillRequest {
  QueueFillMode mode = QueueFillMode::queue;
  double seconds = 0;

  static constexpr auto fields() {
    return Fields{field<&QueueFillRequest::mode>(),
                  field<&QueueFillRequest::seconds>(Unit::s, "of collect and save", {0, 86400})};
  }
};

/// Keeps the newest messages only (report E.3: real time): a message replaces those of its kind
/// that are older; a drawing stays whole, though it comes in several messages, and replaces none of
/// another key.
class NewestMessages {
 public:
  /// Appends the messages of a queue to another one, which loses what they replace.
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

  /// What takes the messages that were collected to be saved.
  void onSave(Saver saver) { saver_ = std::move(saver); }
  /// False if the seconds are none.
  bool request(const QueueFillRequest& request, Time now);
  /// Ends what was asked for some seconds; to be called before messages are taken.
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
