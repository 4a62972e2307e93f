#include "xabsl/TeamCooperation.h"

#include <algorithm>

namespace xabsl {

namespace {

constexpr int mostTicks = 1'000'000;

}  // namespace

TeamCooperation::TeamCooperation(const Model& model) : memberOfState_(model.states.size(), -1) {
  for (std::size_t option = 0; option < model.options.size(); ++option) {
    const Span states = model.options[option].states;
    for (int state = states.first; state < states.first + states.count; ++state) {
      const Cooperation& cooperation = model.states[static_cast<std::size_t>(state)].cooperation;
      if (cooperation.kind == Cooperation::Kind::none) continue;
      memberOfState_[static_cast<std::size_t>(state)] = static_cast<int>(members_.size());
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
    member.othersReady = 0;
    member.othersPreferred = 0;
    for (const CooperationMessage& message : messages) {
      const std::uint8_t marks = i < message.marks.size() ? message.marks[i] : std::uint8_t{0};
      const bool executing = (marks & CooperationMessage::executing) != 0;
      const bool entering = (marks & CooperationMessage::entering) != 0;
      member.othersInOption += (marks & CooperationMessage::optionExecuted) != 0;
      member.othersExecuting += executing;
      member.othersReady += executing || entering;
      member.othersPreferred += entering && !executing && message.priority >= message_.priority;
    }
  }
}

/// An announcement counts only if it goes on from cycle to cycle.
void TeamCooperation::beginCycle() {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if ((message_.marks[i] & CooperationMessage::entering) == 0) members_[i].announced = 0;
    message_.marks[i] = 0;
  }
}

void TeamCooperation::markOption(int option, int state) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (members_[i].option != option) continue;
    message_.marks[i] |= CooperationMessage::optionExecuted;
    if (members_[i].state == state) message_.marks[i] |= CooperationMessage::executing;
  }
}

bool TeamCooperation::mayEnter(int state) {
  const int index = memberOfState_[static_cast<std::size_t>(state)];
  if (index < 0) return true;
  Member& member = members_[static_cast<std::size_t>(index)];
  if (member.announced <= synchronizationTicks_) ++member.announced;
  const int agents = member.cooperation.agents;
  const bool agreed = member.cooperation.kind == Cooperation::Kind::capacity
                          ? member.othersExecuting + member.othersPreferred < agents &&
                                member.announced > synchronizationTicks_
                          : member.othersInOption + 1 >= agents &&
                                member.othersReady >= member.othersInOption &&
                                member.announced > synchronizationTicks_ / 2;
  if (!agreed) message_.marks[static_cast<std::size_t>(index)] |= CooperationMessage::entering;
  return agreed;
}

bool TeamCooperation::conflict(int state) const {
  const int index = memberOfState_[static_cast<std::size_t>(state)];
  if (index < 0) return false;
  const Member& member = members_[static_cast<std::size_t>(index)];
  return member.cooperation.kind == Cooperation::Kind::capacity &&
         member.othersExecuting >= member.cooperation.agents;
}

}  // namespace xabsl
