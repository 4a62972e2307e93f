#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

namespace gt {

/// A message for a client of a WebSocketServer. What is sent to many clients is kept once.
struct WebSocketMessage {
  bool binary = false;
  std::string head{};  ///< Of this client.
  std::shared_ptr<const std::string> body{};
  /// A pending message is replaced by a newer one with the same number, so that slow clients
  /// receive the newest message. 0: never replaced, but dropped if too many bytes are pending and
  /// the message is droppable.
  std::uint32_t newestOf = 0;
  bool droppable = true;  ///< Clients that do not receive messages that are not droppable are
                          ///< disconnected.
  bool urgent = false;    ///< Whether it is sent before all pending messages that are not urgent.
};

/// The messages that are pending for one client.
class WebSocketOutbox {
 public:
  enum class Outcome { first, waits, dropped, full };

  /// Takes a message if there is room: up to so many bytes before messages are dropped. Returns
  /// `first` if nothing is being sent: then it is time to take a message. Returns `full` if a
  /// client does not take what is not droppable.
  Outcome put(WebSocketMessage message, std::size_t mostWaiting);
  /// Whether a droppable message would be sent: nothing was dropped since the last one was taken,
  /// and none of the same number waits.
  bool takes(std::uint32_t newestOf) const { return !isFull_ && !newest_.contains(newestOf); }
  /// The next message to send, the one before it being sent.
  std::optional<WebSocketMessage> take();

 private:
  std::deque<WebSocketMessage> urgent_;
  std::list<WebSocketMessage> waiting_;
  /// Those of `waiting_` that the next one of their number replaces.
  std::unordered_map<std::uint32_t, std::list<WebSocketMessage>::iterator> newest_;
  std::size_t bytes_ = 0;    ///< Of what waits and what is being sent.
  std::size_t sending_ = 0;  ///< Bytes of the message that is being sent.
  bool isSending_ = false;
  bool isFull_ = false;  ///< A message was dropped since the last one was taken.
};

}  // namespace gt
