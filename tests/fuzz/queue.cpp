#include <span>

#include "Fuzz.h"
#include "debug/Drawing.h"
#include "framework/Requests.h"
#include "streams/MessageQueue.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gt::MessageQueue queue;
  if (!queue.assign(std::as_bytes(std::span{data, size}))) return 0;
  queue.handleAllMessages([](const gt::Message& message) {
    gt::Drawing drawing;
    (void)!message.read(drawing);
    gt::Text text;
    (void)!message.read(text);
    gt::SolutionRequest request;
    (void)!message.read(request);
  });
  return 0;
}
