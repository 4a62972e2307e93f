#include "simulation/rules/GameController.h"

#include "Fuzz.h"
#include "match/GameControllerChoice.h"

/// A game controller's messages, the answers to them, and whom of two senders is followed. The
/// first byte of each says how long the next message is, and from whom.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span{data, size});
  if (const auto message = gt::parseGameController(bytes))
    (void)gt::answerBytes({}, message->version);
  gt::GameControllerChoice choice;
  for (std::size_t at = 0; at < size;) {
    const std::uint8_t head = data[at++];
    const std::size_t length = std::min<std::size_t>(head, size - at);
    const auto part = bytes.subspan(at, length);
    const auto time = static_cast<std::int64_t>(at) * 64;
    (void)choice.take({{part.begin(), part.end()}, head % 2 == 0 ? "a:1" : "b:2", time});
    at += length;
  }
  (void)choice.takeNews();
  return 0;
}
