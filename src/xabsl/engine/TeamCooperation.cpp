#include "xabsl/engine/TeamCooperation.h"

#include <algorithm>
#include <utility>

namespace xabsl {

namespace {

constexpr int mostTicks = 1'000'000;

}  // namespace

TeamCooperation::TeamCooperation(const Model& model) : memberOfState_(model.states.size(), -1) {
  for (std::size_t option = 0; option < model.options.size(); ++option) {
    const Span states = model.options[option].states;
    for (const int state : states) {
      const Cooperation& cooperation = model.states[at(state)].cooperation;
      if (cooperation.kind == Cooperation::Kind::none) continue;
      memberOfState_[at(state)] = static_cast<int>(members_.size());
      Member member;
      member.option = static_cast<int>(option);
      member.state = state;
      member.cooperation = cooperation;
      members_.push_back(member);
    }
  }
  message_.marks.resize(members_.size());
}

void TeamCooperation::configure(double priority, int synchronizationTicks) {
  message_.priority = priority;
  synchronizationTicks_ = std::clamp(synchronizationTicks, 0, mostTicks);
}

void TeamCooperation::receive(const std::vector<CooperationMessage>& messages) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Member& member = members_[i];
    member.othersInOption = 0;
    member.othersExecuting = 0;
    member.othersEntering = 0;
    for (const CooperationMessage& message : messages) {
      const std::uint8_t marks = i < message.marks.size() ? message.marks[i] : std::uint8_t{0};
      const bool executing = (marks & CooperationMessage::executing) != 0;
      const bool entering = !executing && (marks & CooperationMessage::entering) != 0;
      member.othersInOption += (marks & CooperationMessage::optionExecuted) != 0;
      member.othersExecuting += executing;
      if (entering && (member.othersEntering == 0 || message.priority > member.largestPriority))
        member.largestPriority = message.priority;
      member.othersEntering += entering;
    }
  }
}

/// An announcement counts only if it is repeated from cycle to cycle.
void TeamCooperation::beginCycle() {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Member& member = members_[i];
    member.announced =
        std::exchange(member.entering, false) ? std::min(member.announced + 1, mostTicks) : 0;
    message_.marks[i] = 0;
  }
}

void TeamCooperation::markOption(int option, int state) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (members_[i].option != option) continue;
    message_.marks[i] = CooperationMessage::optionExecuted;
    if (members_[i].state == state)
      message_.marks[i] |= CooperationMessage::executing;
    else if (members_[i].entering)
      message_.marks[i] |= CooperationMessage::entering;
  }
}

bool TeamCooperation::mayEnter(int state) {
  const int index = memberOfState_[at(state)];
  if (index < 0) return true;
  Member& member = members_[at(index)];
  return member.cooperation.kind == Cooperation::Kind::capacity ? hasPlace(member)
                                                                : isTogether(member);
}

bool TeamCooperation::hasPlace(Member& member) const {
  const int agents = member.cooperation.agents;
  const bool full = member.othersExecuting >= agents;
  const bool contested = !full && member.othersExecuting + member.othersEntering >= agents;
  // As the engines of other teams do it: of equal rivals none announces the state any longer.
  if (contested && member.largestPriority == message_.priority) return false;
  const bool free = !full && !(contested && member.largestPriority > message_.priority) &&
                    member.announced >= synchronizationTicks_;
  member.entering = !free;
  return free;
}

bool TeamCooperation::isTogether(Member& member) const {
  member.entering = true;
  const int counted = member.othersInOption + (countsTeammatesOnly_ ? 0 : 1);
  return counted >= member.cooperation.agents &&
         member.othersExecuting + member.othersEntering >= member.othersInOption &&
         member.announced > synchronizationTicks_ / 2;
}

bool TeamCooperation::conflict(int state) const {
  const int index = memberOfState_[at(state)];
  if (index < 0) return false;
  const Member& member = members_[at(index)];
  return member.cooperation.kind == Cooperation::Kind::capacity &&
         member.othersExecuting >= member.cooperation.agents;
}

}  // namespace xabsl
