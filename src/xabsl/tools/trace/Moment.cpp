#include "xabsl/tools/trace/Moment.h"

namespace xabsl {

Moment::Moment(const TraceSubject& subject)
    : subject_(subject),
      symbols_(subject.model.symbols.size()),
      options_(subject.model.options.size()),
      behaviors_(subject.model.behaviors.size()) {
  for (std::size_t i = 0; i < options_.size(); ++i)
    options_[i].parameters.resize(subject.model.options[i].parameters.size());
  for (std::size_t i = 0; i < behaviors_.size(); ++i)
    behaviors_[i].parameters.resize(subject.model.behaviors[i].parameters.size());
}

void Moment::take(const TraceEvent* first, const TraceEvent* last) {
  for (OptionMoment& option : options_) {
    option.previous = option.state;
    option.state = -1;
  }
  for (BehaviorMoment& behavior : behaviors_) behavior.active = false;
  std::vector<double>* parameters = nullptr;
  OptionMoment* option = nullptr;
  for (const TraceEvent* event = first; event != last; ++event) {
    const auto index = static_cast<std::size_t>(event->index);
    switch (event->kind) {
      case TraceEvent::Kind::cycle:
        now_ = event->value;
        break;
      case TraceEvent::Kind::read:
        if (const int symbol = subject_.reads[index].symbol; symbol >= 0) set(symbol, event->value);
        break;
      case TraceEvent::Kind::assign:
        symbols_[index] = event->value;
        break;
      case TraceEvent::Kind::state:
        option = &options_[at(subject_.optionOf(event->index))];
        option->state = event->index;
        option->stateTime = event->value;
        break;
      case TraceEvent::Kind::optionTime:
        options_[index].optionTime = event->value;
        parameters = &options_[index].parameters;
        break;
      case TraceEvent::Kind::behavior:
        behaviors_[index].active = true;
        parameters = &behaviors_[index].parameters;
        break;
      case TraceEvent::Kind::parameter:
        if (parameters && index < parameters->size()) (*parameters)[index] = event->value;
        break;
      case TraceEvent::Kind::option:
      case TraceEvent::Kind::argument:
      case TraceEvent::Kind::decide:
      case TraceEvent::Kind::change:
        break;
    }
  }
}

}  // namespace xabsl
