#pragma once
#include <optional>
#include <string>

#include "base/CrashNotes.h"
#include "framework/Requests.h"

namespace gt {

/// The types of requests that a part of a robot carries out: `ModuleProcess`, `DebugProcess` and
/// `Robot` have one list each (`Requests`). The part, for a robot `Robot::Whole`, has a function
/// `request(wanted)` for each type of its list. A `concerns(wanted)` beside it says which requests
/// of that type are its own; without one, all are.
template <typename... Request>
struct RequestTypes {
  static bool contains(const Message& message) { return (message.is<Request>() || ...); }

  /// Lets a part execute a message. Returns the answer in the name of a process; empty if the
  /// message is not one of these requests.
  template <typename Part>
  static std::optional<RequestAnswer> carryOut(const Message& message, const std::string& process,
                                               Part& part) {
    std::optional<RequestAnswer> answer;
    static_cast<void>(((message.is<Request>() &&
                        (answer = carryOutAs<Request>(message, process, part)).has_value()) ||
                       ...));
    return answer;
  }

  /// Removes all these requests from the tools' messages and lets a part execute them, the oldest of
  /// them first; requests of other types keep their place. `answer(RequestAnswer)` is called after each. The part may replace the queue meanwhile.
  template <typename Part, typename Answer>
  static void carryOutAll(MessageQueue& fromTools, const std::string& process, Part& part,
                          Answer answer) {
    bool any = false;
    fromTools.handleAllMessages([&](const Message& message) { any |= contains(message); });
    if (!any) return;
    MessageQueue taken{fromTools.size()};
    fromTools.removeIf(
        [&](const Message& message) { return contains(message) && taken.append(message); });
    taken.handleAllMessages(
        [&](const Message& message) { answer(*carryOut(message, process, part)); });
  }

 private:
  template <typename Wanted, typename Part>
  static RequestAnswer carryOutAs(const Message& message, const std::string& process, Part& part) {
    noteForCrashReport(typeName<Wanted>());
    Wanted wanted;
    if (const auto done = message.read(wanted); !done) return answerTo(message, process, done);
    if constexpr (requires { part.concerns(wanted); })
      if (!part.concerns(wanted)) return notConcerned(message, process);
    return answerTo(message, process, part.request(wanted));
  }
};

}  // namespace gt
