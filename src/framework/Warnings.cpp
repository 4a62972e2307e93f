#include "framework/Warnings.h"

#include "framework/Requests.h"

namespace gt {

Findings warningsIn(const MessageQueue& messages, const std::string& robot) {
  Findings findings;
  messages.handleAllMessages([&](const Message& message) {
    const auto report = [&](std::string field, std::string what, Severity severity) {
      findings.add({.file = robot + " at " + std::to_string(message.time.ms) + " ms",
                    .field = std::move(field),
                    .what = std::move(what),
                    .severity = severity});
    };
    if (message.is<Text>()) {
      Text text;
      if (message.read(text) && text.severity != Severity::note)
        report("", text.text, text.severity);
    } else if (message.is<RequestAnswer>()) {
      RequestAnswer answer;
      if (message.read(answer) && answer.outcome == RequestOutcome::refused)
        report(answer.process, answer.what, Severity::warning);
    } else if (message.is<DroppedMessages>()) {
      DroppedMessages dropped;
      if (!message.read(dropped)) return;
      for (const DroppedMessage& type : dropped.types)
        report(type.type, "dropped " + std::to_string(type.count) + " messages", Severity::warning);
    }
  });
  return findings;
}

}  // namespace gt
