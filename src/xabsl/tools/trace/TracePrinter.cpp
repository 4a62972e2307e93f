#include "xabsl/tools/trace/TracePrinter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

namespace xabsl {

namespace {

using Kind = TraceEvent::Kind;

/// Prints one cycle, event by event.
class CyclePrinter {
 public:
  CyclePrinter(const TraceSubject& subject, bool all) : subject_(subject), all_(all) {}

  std::string print(const TraceEvent* first, const TraceEvent* last) {
    for (const TraceEvent* event = first; event != last; ++event) take(*event, event, last);
    return text_;
  }

 private:
  void take(const TraceEvent& event, const TraceEvent* place, const TraceEvent* last) {
    switch (event.kind) {
      case Kind::cycle:
        text_ += subject_.valueText({}, event.value) + " ms\n";
        break;
      case Kind::option:
        depth_ = event.value;
        asked_.clear();
        reads_.clear();
        from_ = -1;
        break;
      case Kind::read:
        read(subject_.reads[at(event.index)], event.value);
        break;
      case Kind::decide:
        decide(event);
        break;
      case Kind::change:
        from_ = event.index;
        break;
      case Kind::state:
        state(event, place, last);
        break;
      case Kind::behavior:
        behavior(event, place, last);
        break;
      case Kind::assign:
        assign(event);
        break;
      case Kind::argument:
      case Kind::optionTime:
      case Kind::parameter:
        break;
    }
  }

  void read(const TraceSubject::Read& read, double value) {
    if (read.text.empty()) return;
    const std::string text = read.text + " = " + shown(read.type, value);
    if (std::find(reads_.begin(), reads_.end(), text) == reads_.end()) reads_.push_back(text);
  }

  void decide(const TraceEvent& event) {
    const TraceSubject::Condition& condition = subject_.conditions[at(event.index)];
    std::string line = event.value != 0 ? "yes: " : "no:  ";
    line += condition.text + "  (" + subject_.place(condition.location) + ")\n";
    asked_.push_back(line);
    std::string values;
    for (const std::string& value : reads_) values += (values.empty() ? "" : ", ") + value;
    if (!values.empty()) asked_.push_back("     " + values + "\n");
    reads_.clear();
  }

  /// A call's arguments; they stand behind its event.
  std::string arguments(const std::vector<Parameter>& parameters, const TraceEvent* event,
                        const TraceEvent* last) const {
    std::string text;
    for (; event != last && event->kind == Kind::parameter; ++event) {
      const auto index = static_cast<std::size_t>(event->index);
      if (index < parameters.size())
        text += (text.empty() ? "" : ", ") + parameters[index].name + " = " +
                shown(parameters[index].type, event->value);
    }
    return "(" + text + ")";
  }

  void state(const TraceEvent& event, const TraceEvent* place, const TraceEvent* last) {
    const Option& option = subject_.model.options[at(subject_.optionOf(event.index))];
    const TraceEvent* behind = place + 1;
    if (behind != last && behind->kind == Kind::optionTime) ++behind;
    std::string line = option.name + arguments(option.parameters, behind, last) + ": ";
    if (from_ >= 0) line += subject_.state(from_).name + " -> ";
    const State& state = subject_.state(event.index);
    line += state.name + (state.target ? " (target)" : "");
    if (from_ < 0) line += " for " + subject_.valueText({}, event.value) + " ms";
    indent(0);
    text_ += line + "\n";
    if (from_ < 0 && !all_) return;
    for (const std::string& asked : asked_) {
      indent(2);
      text_ += asked;
    }
  }

  void behavior(const TraceEvent& event, const TraceEvent* place, const TraceEvent* last) {
    const BasicBehavior& behavior = subject_.model.behaviors[at(event.index)];
    depth_ = event.value;
    indent(0);
    text_ += behavior.name + arguments(behavior.parameters, place + 1, last) + "\n";
  }

  void assign(const TraceEvent& event) {
    if (!all_) return;
    const Symbol& symbol = subject_.model.symbols[at(event.index)];
    indent(1);
    text_ += symbol.name + " = " + shown(symbol.type, event.value) + "\n";
  }

  /// Six digits are enough to see why.
  std::string shown(Type type, double value) const {
    if (type.kind != ValueKind::number || value == std::trunc(value))
      return subject_.valueText(type, value);
    char buffer[32];
    return {
        buffer,
        std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, 6).ptr};
  }

  void indent(int more) {
    constexpr double deepest = 200;
    const double depth = std::clamp(depth_, 0.0, deepest);  // not a number: as it is
    if (depth == depth) text_.append(2 * (1 + static_cast<std::size_t>(depth)), ' ');
    text_.append(2 * static_cast<std::size_t>(more), ' ');
  }

  const TraceSubject& subject_;
  bool all_;
  double depth_ = 0;
  int from_ = -1;
  std::vector<std::string> asked_;
  std::vector<std::string> reads_;  // since the last decision
  std::string text_;
};

}  // namespace

bool isEventful(const TraceEvent* first, const TraceEvent* last, const TraceEvent* before) {
  const auto isPath = [](const TraceEvent& event) {
    return event.kind == Kind::option || event.kind == Kind::state || event.kind == Kind::behavior;
  };
  // Events before the first one are those of the cycle before.
  for (const TraceEvent* event = first; event != last; ++event) {
    if (event->kind == Kind::change) return true;
    if (!isPath(*event)) continue;
    while (before && before != first && !isPath(*before)) ++before;
    if (!before || before == first || before->kind != event->kind || before->index != event->index)
      return true;
    ++before;
  }
  while (before && before != first && !isPath(*before)) ++before;
  return before && before != first;
}

std::string printCycle(const TraceSubject& subject, const TraceEvent* first, const TraceEvent* last,
                       bool all) {
  return CyclePrinter(subject, all).print(first, last);
}

}  // namespace xabsl
