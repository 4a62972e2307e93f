#include <algorithm>
#include <charconv>

#include "xabsl/tools/trace/TraceFile.h"

namespace xabsl {

namespace {

/// Writes a subject line by line.
class SubjectWriter {
 public:
  explicit SubjectWriter(const TraceSubject& subject) : subject_(subject), model_(subject.model) {}

  std::string write() {
    line("xabsl trace 1");
    for (const std::string& file : model_.files) line("file " + oneLine(file));
    enumerations();
    for (const Symbol& symbol : model_.symbols) {
      line(std::string("symbol ") + wordOf(symbol.kind) + " " + type(symbol.type) + symbol.name);
      parameters(symbol.parameters);
    }
    for (const BasicBehavior& behavior : model_.behaviors) {
      line("behavior " + behavior.name);
      parameters(behavior.parameters);
    }
    for (const Option& option : model_.options) write(option);
    for (std::size_t i = 0; i < model_.decisions.size(); ++i)
      line("decision " + place(subject_.conditions[i].location) + tree(model_.decisions[i].then) +
           tree(model_.decisions[i].otherwise) + oneLine(subject_.conditions[i].text));
    for (const TraceSubject::Read& read : subject_.reads)
      line(read.text.empty() ? "none"
                             : "read " + type(read.type) + std::to_string(read.symbol) + " " +
                                   oneLine(read.text));
    line("cycles");
    return std::move(text_);
  }

 private:
  void enumerations() {
    for (std::size_t i = 0; i < model_.enumerations.size(); ++i) {
      line("enumeration " + model_.enumerations[i].name);
      const auto& elements = model_.enumerations[i].elements;
      for (std::size_t e = 0; e < elements.size(); ++e)
        line("element " + subject_.valueText({}, subject_.elementValues[i][e]) + " " +
             elements[e].name);
    }
  }

  void write(const Option& option) {
    line("option " + place(option.location) + tree(option.commonDecision) + option.name);
    parameters(option.parameters);
    for (const int i : option.states) {
      const State& state = subject_.state(i);
      const bool initial = i == option.initialState;
      line("state " + place(state.location) +
           (initial ? (state.target ? "both " : "initial ")
                    : (state.target ? "target " : "normal ")) +
           tree(state.decision) + state.name);
    }
  }

  void parameters(const std::vector<Parameter>& parameters) {
    for (const Parameter& parameter : parameters)
      line("parameter " + type(parameter.type) + parameter.name);
  }

  static std::string oneLine(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
  }
  static std::string type(Type type) {
    return type.kind == ValueKind::number    ? "float "
           : type.kind == ValueKind::boolean ? "bool "
                                             : std::to_string(type.enumeration) + " ";
  }
  static std::string tree(Branch branch) {
    switch (branch.kind) {
      case Branch::Kind::decision:
        return "d" + std::to_string(branch.index) + " ";
      case Branch::Kind::state:
        return "s" + std::to_string(branch.index) + " ";
      case Branch::Kind::stay:
        return "stay ";
      case Branch::Kind::none:
        return "none ";
    }
    return {};
  }
  static std::string place(Location location) {
    return std::to_string(location.file) + " " + std::to_string(location.line) + " ";
  }
  void line(const std::string& text) { text_ += text + "\n"; }

  const TraceSubject& subject_;
  const Model& model_;
  std::string text_;
};

}  // namespace

std::string toText(const TraceSubject& subject) {
  return SubjectWriter(subject).write();
}

std::string toText(const std::vector<TraceEvent>& events) {
  std::string text;
  char buffer[64];
  for (const TraceEvent& event : events) {
    char* end = buffer;
    *end++ = traceLetters[static_cast<std::size_t>(event.kind)];
    *end++ = ' ';
    if (event.kind != TraceEvent::Kind::cycle) {
      end = std::to_chars(end, buffer + sizeof(buffer), event.index).ptr;
      *end++ = ' ';
    }
    end = std::to_chars(end, buffer + sizeof(buffer), event.value).ptr;
    *end++ = '\n';
    text.append(buffer, end);
  }
  return text;
}

}  // namespace xabsl
