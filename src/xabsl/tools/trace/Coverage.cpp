#include "xabsl/tools/trace/Coverage.h"

#include <algorithm>

namespace xabsl {

Coverage::Coverage(const TraceSubject& subject)
    : subject_(subject),
      waysOfDecision_(subject.model.decisions.size()),
      active_(subject.model.states.size()) {
  // A decision is asked in one tree only; a trace from outside may differ.
  std::vector<bool> seen(subject.model.decisions.size());
  for (std::size_t i = 0; i < subject.model.options.size(); ++i) {
    const Option& option = subject.model.options[i];
    collect(option.commonDecision, static_cast<int>(i), -1, -1, true, seen);
    for (const int s : option.states)
      collect(subject.state(s).decision, static_cast<int>(i), s, -1, true, seen);
  }
}

void Coverage::collect(Branch branch, int option, int from, int decision, bool held,
                       std::vector<bool>& seen) {
  if (branch.kind == Branch::Kind::state && branch.index != from) {
    if (decision >= 0) waysOfDecision_[at(decision)].push_back(ways_.size());
    ways_.push_back({option, from, branch.index, decision, held, 0});
  }
  // A chain of decisions may be long: its end is followed in a loop.
  while (branch.kind == Branch::Kind::decision && !seen[at(branch.index)]) {
    seen[at(branch.index)] = true;
    const int index = branch.index;
    const Decision& next = subject_.model.decisions[at(index)];
    collect(next.then, option, from, index, true, seen);
    branch = next.otherwise;
    if (branch.kind != Branch::Kind::decision) collect(branch, option, from, index, false, seen);
  }
}

void Coverage::add(const std::vector<TraceEvent>& events) {
  bool byCondition = false;  // whether the last condition asked led to a state
  for (const TraceEvent& event : events) {
    const auto index = static_cast<std::size_t>(event.index);
    if (event.kind == TraceEvent::Kind::option) {
      byCondition = false;
    } else if (event.kind == TraceEvent::Kind::state) {
      ++active_[index];
    } else if (event.kind == TraceEvent::Kind::decide) {
      byCondition = false;
      for (const std::size_t way : waysOfDecision_[index])
        if (ways_[way].held == (event.value != 0)) {
          ++ways_[way].taken;
          byCondition = true;
        }
    } else if (event.kind == TraceEvent::Kind::change && !byCondition) {
      for (Way& way : ways_)
        if (way.decision < 0 && way.from == event.index) ++way.taken;
    }
  }
}

std::string Coverage::describe(const Way& way) const {
  const Option& option = subject_.model.options[at(way.option)];
  std::string text = option.name + ": " + (way.from < 0 ? "any" : subject_.state(way.from).name) +
                     " -> " + subject_.state(way.to).name;
  if (way.decision < 0) return text;
  const TraceSubject::Condition& condition = subject_.conditions[at(way.decision)];
  return text + (way.held ? " if " : " if not ") + condition.text;
}

std::string Coverage::report() const {
  std::string text;
  for (std::size_t i = 0; i < subject_.model.options.size(); ++i) {
    const Option& option = subject_.model.options[i];
    for (const int s : option.states) {
      if (active_[at(s)] == 0) {
        text += subject_.place(subject_.state(s).location) + ": state " + option.name + "/" +
                subject_.state(s).name + " was never active\n";
        continue;
      }
      for (const Way& way : ways_)
        if (way.from == s && way.taken == 0)
          text +=
              subject_.place(way.decision < 0 ? subject_.state(s).location
                                              : subject_.conditions[at(way.decision)].location) +
              ": never " + describe(way) + "\n";
    }
    for (const Way& way : ways_)
      if (way.from < 0 && way.option == static_cast<int>(i) && way.taken == 0)
        text += subject_.place(option.location) + ": never " + describe(way) + "\n";
  }
  const auto states =
      std::count_if(active_.begin(), active_.end(), [](long cycles) { return cycles > 0; });
  const auto ways =
      std::count_if(ways_.begin(), ways_.end(), [](const Way& way) { return way.taken > 0; });
  return text + std::to_string(states) + " of " + std::to_string(active_.size()) + " states, " +
         std::to_string(ways) + " of " + std::to_string(ways_.size()) + " transitions\n";
}

}  // namespace xabsl
