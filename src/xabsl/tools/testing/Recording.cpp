#include "xabsl/tools/testing/Recording.h"

#include <algorithm>

#include "xabsl/language/ExpressionAnalyzer.h"

namespace xabsl {

Recording::Recording(std::vector<Trace> traces, const Model& model)
    : traces_(std::move(traces)), model_(model) {}

void Recording::restart() {
  trace_ = event_ = 0;
  inputs_.clear();
  calls_.clear();
  last_.clear();
}

bool Recording::nextCycle() {
  while (trace_ < traces_.size() && event_ == traces_[trace_].events.size()) {
    ++trace_;
    event_ = 0;
  }
  if (trace_ == traces_.size()) return false;
  const Trace& trace = traces_[trace_];
  if (event_ == 0) findSymbols(trace);
  inputs_.clear();
  calls_.clear();
  arguments_.clear();
  previousTime_ = std::exchange(time_, trace.events[event_].value);
  do take(trace, trace.events[event_++]);
  while (event_ < trace.events.size() && trace.events[event_].kind != TraceEvent::Kind::cycle);
  return true;
}

void Recording::findSymbols(const Trace& trace) {
  places_.clear();
  for (const Symbol& symbol : trace.subject.model.symbols)
    places_.push_back(place(trace.subject, symbol));
}

Recording::Place Recording::place(const TraceSubject& subject, const Symbol& symbol) const {
  const auto sameType = [&](Type a, Type b) {
    return a.kind == b.kind && (a.kind != ValueKind::enumeration ||
                                subject.model.enumerations[at(a.enumeration)].name ==
                                    model_.enumerations[at(b.enumeration)].name);
  };
  for (std::size_t i = 0; i < model_.symbols.size(); ++i) {
    const Symbol& own = model_.symbols[i];
    if (own.kind != SymbolKind::input || own.name != symbol.name ||
        !sameType(symbol.type, own.type) || own.parameters.size() != symbol.parameters.size())
      continue;
    Place place{static_cast<int>(i), {}};
    for (const Parameter& parameter : symbol.parameters) {
      const int index = findParameter(own.parameters, parameter.name, own.name);
      if (index < 0 || !sameType(parameter.type, own.parameters[at(index)].type)) return {};
      place.parameters.push_back(index);
    }
    return place;
  }
  return {};
}

double Recording::translated(const TraceSubject& subject, Type from, Type to, double value) const {
  if (from.kind != ValueKind::enumeration) return value;
  const std::string name = subject.valueText(from, value);
  const auto& elements = model_.enumerations[at(to.enumeration)].elements;
  return indexOf(elements, name);
}

void Recording::take(const Trace& trace, const TraceEvent& event) {
  if (event.kind == TraceEvent::Kind::argument) {
    arguments_[event.index] = event.value;
    return;
  }
  if (event.kind != TraceEvent::Kind::read) return;
  const auto arguments = std::exchange(arguments_, {});
  const int read = trace.subject.reads[at(event.index)].symbol;
  if (read < 0) return;
  const Place& place = places_[at(read)];
  if (place.symbol < 0) return;
  const Symbol& from = trace.subject.model.symbols[at(read)];
  const Symbol& to = model_.symbols[at(place.symbol)];
  const double value = translated(trace.subject, from.type, to.type, event.value);
  if (to.parameters.empty()) {
    inputs_.emplace_back(place.symbol, value);
    return;
  }
  Called called{std::vector<double>(to.parameters.size()), value};
  for (std::size_t p = 0; p < place.parameters.size(); ++p) {
    const auto given = arguments.find(static_cast<int>(p));
    const auto own = static_cast<std::size_t>(place.parameters[p]);
    if (given != arguments.end())
      called.arguments[own] = translated(trace.subject, from.parameters[p].type,
                                         to.parameters[own].type, given->second);
  }
  calls_[place.symbol].push_back(std::move(called));
  last_[place.symbol] = value;
}

double Recording::call(int symbol, const double* arguments) const {
  const auto calls = calls_.find(symbol);
  if (calls != calls_.end())
    for (const Called& called : calls->second)
      if (std::equal(called.arguments.begin(), called.arguments.end(), arguments))
        return called.result;
  const auto last = last_.find(symbol);
  return last == last_.end() ? 0 : last->second;
}

}  // namespace xabsl
