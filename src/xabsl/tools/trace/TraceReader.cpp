#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "xabsl/language/SourceFiles.h"
#include "xabsl/language/Text.h"
#include "xabsl/tools/trace/TraceFile.h"

namespace xabsl {

namespace {

constexpr std::size_t largestTrace = 128u << 20;
constexpr std::string_view firstLine = "xabsl trace 1";

/// Reads traces line by line; stops at the first error.
class TraceReader {
 public:
  TraceReader(const std::string& name, std::string_view text)
      : name_(name), text_(withoutByteOrderMark(text)) {}

  TraceReading read() {
    TraceReading reading;
    try {
      while (nextLine()) {
        if (rest_ != firstLine) fail("expected '" + std::string(firstLine) + "'");
        readTrace(reading.traces.emplace_back());
      }
      if (reading.traces.empty()) fail("expected '" + std::string(firstLine) + "'");
    } catch (const Diagnostic& diagnostic) {
      reading.traces.clear();
      reading.diagnostics.push_back(diagnostic);
    }
    return reading;
  }

  std::optional<Diagnostic> readMore(Trace& trace) {
    trace_ = &trace;
    try {
      readEvents();
      if (text_.starts_with("xabsl")) fail("another trace begins");
    } catch (const Diagnostic& diagnostic) {
      return diagnostic;
    }
    return std::nullopt;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw Diagnostic{Diagnostic::Severity::error, name_, line_, 1, message};
  }

  /// A line without an end was cut off when it was written.
  bool nextLine() {
    const std::size_t end = text_.find('\n');
    if (end == std::string_view::npos) return false;
    rest_ = text_.substr(0, end);
    while (!rest_.empty() && rest_.back() == '\r') rest_.remove_suffix(1);
    text_.remove_prefix(end + 1);
    ++line_;
    return true;
  }

  std::string_view word() {
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return word;
  }

  template <typename Number>
  Number number(std::string_view text) const {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
      fail(inQuotes(text) + " is not a number");
    return number;
  }

  /// An index into a list of that size.
  int index(std::string_view text, std::size_t size, const char* what) const {
    const int index = number<int>(text);
    if (index < 0 || static_cast<std::size_t>(index) >= size)
      fail("there is no " + std::string(what) + " " + std::string(text));
    return index;
  }

  std::string name() const {
    if (rest_.empty()) fail("a name is missing");
    return std::string(rest_);
  }

  Type type() {
    const std::string_view text = word();
    if (text == "float") return {};
    if (text == "bool") return {ValueKind::boolean, -1};
    return {ValueKind::enumeration, index(text, model().enumerations.size(), "enumeration")};
  }

  Location place() {
    Location location;
    location.file = index(word(), model().files.size(), "file");
    location.line = number<int>(word());
    return location;
  }

  /// Where it leads to may stand further below; see checkTrees().
  Branch tree() {
    const std::string_view text = word();
    if (text == "stay") return {Branch::Kind::stay, -1};
    if (text == "none") return {Branch::Kind::none, -1};
    if (text.empty() || (text[0] != 'd' && text[0] != 's'))
      fail(inQuotes(text) + " is no decision tree");
    return {text[0] == 'd' ? Branch::Kind::decision : Branch::Kind::state,
            number<int>(text.substr(1))};
  }

  void readTrace(Trace& trace) {
    trace_ = &trace;
    parameters_ = nullptr;
    while (nextLine()) {
      if (rest_ == "cycles") {
        checkTrees();
        return readEvents();
      }
      readSubject(word());
    }
    fail("the trace ends before its cycles");
  }

  void readSubject(std::string_view what) {
    if (what == "file") {
      model().files.push_back(name());
    } else if (what == "enumeration") {
      model().enumerations.emplace_back().name = name();
      subject().elementValues.emplace_back();
    } else if (what == "element") {
      if (model().enumerations.empty()) fail("an element without an enumeration");
      subject().elementValues.back().push_back(number<double>(word()));
      model().enumerations.back().elements.push_back({name(), {}});
    } else if (what == "symbol") {
      readSymbol();
    } else if (what == "behavior") {
      BasicBehavior& behavior = model().behaviors.emplace_back();
      behavior.name = name();
      parameters_ = &behavior.parameters;
    } else if (what == "parameter") {
      if (!parameters_) fail("a parameter of nothing");
      const Type of = type();
      parameters_->push_back({name(), of, {}});
    } else if (what == "option") {
      readOption();
    } else if (what == "state") {
      readState();
    } else {
      readDecision(what);
    }
  }

  void readDecision(std::string_view what) {
    if (what == "decision") {
      const Location at = place();
      Decision& decision = model().decisions.emplace_back();
      decision.then = tree();
      decision.otherwise = tree();
      subject().conditions.push_back({name(), at});
    } else if (what == "read") {
      TraceSubject::Read read;
      read.type = type();
      const std::string_view symbol = word();
      if (symbol != "-1") read.symbol = index(symbol, model().symbols.size(), "symbol");
      read.text = name();
      subject().reads.push_back(std::move(read));
    } else if (what == "none") {
      subject().reads.emplace_back();
    } else {
      fail(inQuotes(what) + " is no part of a behavior");
    }
  }

  void readSymbol() {
    const std::string_view kind = word();
    Symbol& symbol = model().symbols.emplace_back();
    if (kind == "output")
      symbol.kind = SymbolKind::output;
    else if (kind == "internal")
      symbol.kind = SymbolKind::internal;
    else if (kind != "input")
      fail(inQuotes(kind) + " is no kind of symbol");
    symbol.type = type();
    symbol.name = name();
    parameters_ = &symbol.parameters;
  }

  void readOption() {
    Option& option = model().options.emplace_back();
    option.location = place();
    option.commonDecision = tree();
    option.name = name();
    option.states.first = static_cast<int>(model().states.size());
    parameters_ = &option.parameters;
  }

  void readState() {
    if (model().options.empty()) fail("a state without an option");
    Option& option = model().options.back();
    State& state = model().states.emplace_back();
    state.location = place();
    const std::string_view kind = word();
    state.target = kind == "target" || kind == "both";
    if (kind == "initial" || kind == "both")
      option.initialState = option.states.first + option.states.count;
    else if (!state.target && kind != "normal")
      fail(inQuotes(kind) + " is no kind of state");
    state.decision = tree();
    state.name = name();
    ++option.states.count;
  }

  void checkTrees() const {
    for (const Option& option : model().options) check(option.commonDecision);
    for (const State& state : model().states) check(state.decision);
    for (const Decision& decision : model().decisions) {
      check(decision.then);
      check(decision.otherwise);
    }
  }

  void check(Branch branch) const {
    const bool isState = branch.kind == Branch::Kind::state;
    if (!isState && branch.kind != Branch::Kind::decision) return;
    const std::size_t size = isState ? model().states.size() : model().decisions.size();
    if (branch.index < 0 || static_cast<std::size_t>(branch.index) >= size)
      fail(std::string("a decision tree leads to a ") + (isState ? "state" : "decision") +
           " that is not there: " + std::to_string(branch.index));
  }

  void readEvents() {
    while (!text_.starts_with("xabsl") && nextLine()) {
      const std::string_view letter = word();
      const std::size_t kind =
          letter.size() == 1 ? traceLetters.find(letter[0]) : std::string_view::npos;
      if (kind == std::string_view::npos) fail(inQuotes(letter) + " is no event");
      trace_->events.push_back(event(static_cast<TraceEvent::Kind>(kind)));
      if (trace_->events.front().kind != TraceEvent::Kind::cycle) fail("expected a cycle");
    }
  }

  TraceEvent event(TraceEvent::Kind kind) {
    TraceEvent event{kind, 0, 0};
    if (kind != TraceEvent::Kind::cycle) event.index = eventIndex(kind);
    event.value = number<double>(word());
    if (!rest_.empty()) fail(inQuotes(rest_) + " is too much");
    if (kind == TraceEvent::Kind::change) {
      if (!(event.value >= 0 && event.value < static_cast<double>(model().states.size())) ||
          event.value != std::floor(event.value))
        fail("there is no such state");
    }
    return event;
  }

  /// Parameters are those of what stands before, or after.
  int eventIndex(TraceEvent::Kind kind) {
    const std::string_view text = word();
    using Kind = TraceEvent::Kind;
    switch (kind) {
      case Kind::option:
      case Kind::optionTime:
        return index(text, model().options.size(), "option");
      case Kind::read:
        return index(text, subject().reads.size(), "expression");
      case Kind::decide:
        return index(text, model().decisions.size(), "decision");
      case Kind::change:
      case Kind::state:
        return index(text, model().states.size(), "state");
      case Kind::behavior:
        return index(text, model().behaviors.size(), "basic behavior");
      case Kind::assign:
        return index(text, model().symbols.size(), "symbol");
      case Kind::cycle:
      case Kind::argument:
      case Kind::parameter:
        break;
    }
    constexpr std::size_t mostParameters = 1'000'000;
    return index(text, mostParameters, "parameter");
  }

  TraceSubject& subject() { return trace_->subject; }
  Model& model() { return trace_->subject.model; }
  const Model& model() const { return trace_->subject.model; }

  const std::string& name_;
  std::string_view text_;
  std::string_view rest_;  // of the line
  int line_ = 0;
  Trace* trace_ = nullptr;
  std::vector<Parameter>* parameters_ = nullptr;
};

}  // namespace

TraceReading readTraces(const std::string& name, std::string_view text) {
  return TraceReader(name, text).read();
}

std::optional<Diagnostic> readMore(Trace& trace, const std::string& name, std::string_view text) {
  return TraceReader(name, text).readMore(trace);
}

TraceReading loadTraces(const std::string& path) {
  std::string text;
  if (const auto failure = readFile(path, text, largestTrace))
    return {{}, {{Diagnostic::Severity::error, path, 0, 0, *failure}}};
  return readTraces(path, text);
}

}  // namespace xabsl
