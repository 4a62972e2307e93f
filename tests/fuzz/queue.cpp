#include <span>

#include "Fuzz.h"
#include "debug/Drawing.h"
#include "framework/QueueFill.h"
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
  // What a queue holds can be copied, moved, dropped and replaced, whatever it is.
  gt::MessageQueue small{size / 2}, other;
  queue.copyAllMessages(small);
  small.reportDropped({});
  queue.copyMessages(gt::messageId<gt::Drawing>(), other);
  gt::QueueFill fill;
  (void)fill.request({gt::QueueFillMode::replace, 0}, {});
  for (int i = 0; i < 2; ++i) fill.take(queue, other);
  queue.moveMessages(gt::messageId<gt::Text>(), other);
  queue.moveAllMessages(other);
  if (!queue.empty() || !queue.assign(other.bytes())) __builtin_trap();
  return 0;
}
