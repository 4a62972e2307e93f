#include "simulation/rules/GameController.h"

#include <span>

#include "Fuzz.h"

/// A game controller's messages, and the answers to them.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto message = gt::parseGameController(std::as_bytes(std::span{data, size}));
  if (message) (void)gt::answerBytes({}, message->version);
  return 0;
}
