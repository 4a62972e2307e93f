#include <cmath>

#include "base/Number.h"
#include "representations/behavior/BehaviorState.h"
#include "views/ViewText.h"
#include "views/Views.h"

namespace gt {
namespace {

/// A value with its unit; numbers with as many digits as a person can use.
std::string textOf(const BehaviorValue& value) {
  const auto number = numberFrom<double>(value.value);
  std::string text = value.value;
  if (number && std::isfinite(*number)) {
    text = decimal(*number, std::abs(*number) < 10 ? 2 : 1);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (value.unit.empty()) return text;
  return text + (value.unit == "deg" ? "\u00B0" : " " + value.unit);
}

std::string duration(std::int64_t ms) {
  return decimal(static_cast<double>(ms) / 1000) + " s";
}

class XabslView : public View {
 public:
  XabslView() : View{"xabsl", "options, basic behavior and the symbols that were asked for"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const BehaviorState* const newest = (*robot)->newest<BehaviorState>();
    const BehaviorState state = newest ? *newest : BehaviorState{};
    std::size_t count = 8 + state.inputs.size() + state.outputs.size();
    for (const auto& activation : state.activations) count += 1 + activation.parameters.size();
    Sheet sheet{640, TextLines::sheetHeight(count)};
    TextLines lines{sheet, 16};
    lines.add({{0, (*robot)->name() + "   Agent: " + state.agent}});
    lines.heading("Option Activation Path");
    for (const auto& a : state.activations) add(lines, a);
    addSymbols(lines, "Input Symbols", state.inputs);
    addSymbols(lines, "Output Symbols", state.outputs);
    if (!newest) lines.add({{0, "nothing came; try dk sendXabsl2DebugMessages on"}}, faintText);
    return sheet;
  }

 private:
  static void add(TextLines& lines, const BehaviorState::Activation& a) {
    const bool option = !a.state.empty();
    if (!option) lines.heading("Active Basic Behavior");
    lines.add({{12.0 + 12 * a.depth, a.name},
               {250, option ? duration(a.optionTime) : ""},
               {330, a.state},
               {560, option ? duration(a.stateTime) : ""}});
    for (const BehaviorValue& p : a.parameters)
      lines.add({{30.0 + 12 * a.depth, p.name + " = " + textOf(p)}}, faintText);
  }
  static void addSymbols(TextLines& lines, const char* heading,
                         const std::vector<BehaviorValue>& symbols) {
    if (symbols.empty()) return;
    lines.heading(heading);
    for (const BehaviorValue& symbol : symbols)
      lines.add({{12, symbol.name}, {330, textOf(symbol)}});
  }
};

}  // namespace

std::unique_ptr<View> makeXabslView() {
  return std::make_unique<XabslView>();
}

}  // namespace gt
