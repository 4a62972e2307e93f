#include "modules/behavior/control/GT2003BehaviorControl.h"

#include <filesystem>

#include "motionnet/Listing.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/BehaviorTrace.h"
#include "xabsl/tools/trace/TraceFile.h"

namespace gt {
namespace {

const DebugKey sendActivations{"BehaviorControl/activations"};
const DebugKey sendTrace{"BehaviorControl/trace"};
const DebugKey engineTime{"BehaviorControl/engine"};
const DebugKey drawField{"BehaviorControl/potentialField"};

/// The parameters of an option or a basic behavior; null if no element has that name.
template <typename T>
const std::vector<xabsl::Parameter>* parametersOf(const std::vector<T>& list,
                                                  const std::string& name) {
  for (const T& element : list)
    if (element.name == name) return &element.parameters;
  return nullptr;
}

std::string unitOf(const std::vector<xabsl::Parameter>* declared, const std::string& name) {
  if (declared)
    for (const xabsl::Parameter& parameter : *declared)
      if (parameter.name == name) return parameter.unit;
  return "";
}

BehaviorState stateOf(const xabsl::Engine& engine, const std::vector<std::string>& shown) {
  const xabsl::Model& model = engine.model();
  BehaviorState state;
  state.agent = engine.selectedAgent();
  for (const xabsl::Activation& a : engine.activations()) {
    const auto* declared = a.kind == xabsl::Activation::Kind::option
                               ? parametersOf(model.options, a.name)
                               : parametersOf(model.behaviors, a.name);
    state.activations.push_back({a.name, a.state, a.depth, a.optionTime, a.stateTime, {}});
    for (const xabsl::NamedValue& value : a.parameters)
      state.activations.back().parameters.push_back(
          {value.name, value.text, unitOf(declared, value.name)});
  }
  for (const std::string& name : shown) {
    const auto value = engine.symbol(name);
    if (!value) continue;
    const int output = model.findOutput(name);
    const auto index = static_cast<std::size_t>(output >= 0 ? output : model.findInput(name));
    (output >= 0 ? state.outputs : state.inputs)
        .push_back({name, value->text, model.symbols[index].unit});
  }
  return state;
}

/// Names files as in the attachments of a log: behavior/ and the path relative to the agents file's
/// folder, so that a trace does not depend on the location of the files.
void nameAsInLogs(std::vector<std::string>& files) {
  if (files.empty()) return;
  const std::filesystem::path folder = std::filesystem::path{files.front()}.parent_path();
  for (std::string& file : files)
    file = (std::filesystem::path{"behavior"} /
            std::filesystem::path{file}.lexically_proximate(folder))
               .generic_string();
}

}  // namespace

const xabsl::Symbols& GT2003BehaviorControl::symbols(const MotionNet& motions) {
  std::vector<std::string> names{"none"};
  for (std::size_t i = 1; i < motions.motions.size(); ++i)
    names.push_back(motionnet::xabslName(motions.motions[i].name));
  symbols_.enumeration<SpecialAction>("special_action", std::move(names));
  if (symbols_.inputs().empty())
    soccer::registerSymbols(symbols_, inputs_, outputs_, basicBehaviors_.all());
  return symbols_;
}

void GT2003BehaviorControl::load(const Behavior& behavior, const MotionNet& motions, Debug& debug) {
  loaded_ = behavior.compiled->shared();
  auto creation = xabsl::Engine::create(*behavior.compiled, symbols(motions));
  for (const xabsl::Diagnostic& diagnostic : creation.diagnostics) debug.warn(toString(diagnostic));
  if (!creation.engine) return;
  if (engine_) creation.engine->resumeFrom(*engine_);
  engine_ = std::move(creation.engine);
  recording_ = false;
  agent_.clear();
  applied_ = {};
}

/// Selects the agent that the parameters name, after the behavior or the name has changed.
void GT2003BehaviorControl::chooseAgent(Debug& debug) {
  if (agent_ == parameters.agent) return;
  agent_ = parameters.agent;
  const std::string& agent = agent_.empty() ? engine_->model().agents.front().name : agent_;
  if (!engine_->selectAgent(agent)) debug.warn("the behavior has no agent " + agent);
}

/// Applies a person's request to the engine, once per request.
void GT2003BehaviorControl::apply(const BehaviorControlRequest& control, Debug& debug) {
  if (control == applied_) return;
  const bool otherRoot = control.root != applied_.root ||
                         control.basicBehavior != applied_.basicBehavior ||
                         control.parameters != applied_.parameters;
  applied_ = control;
  if (!otherRoot) return;
  if (control.root.empty()) {
    engine_->selectAgent(engine_->selectedAgent());
    return;
  }
  const xabsl::Model& model = engine_->model();
  const auto* declared = control.basicBehavior ? parametersOf(model.behaviors, control.root)
                                               : parametersOf(model.options, control.root);
  bool done = declared && declared->size() >= control.parameters.size() &&
              (control.basicBehavior ? engine_->selectBehavior(control.root)
                                     : engine_->selectRootOption(control.root));
  for (std::size_t i = 0; done && i < control.parameters.size(); ++i)
    done = engine_->setParameter((*declared)[i].name, control.parameters[i]);
  if (!done) debug.warn("the behavior has no " + control.root + " with these parameters");
}

/// Records the description of the traced behavior once, then each cycle separately.
void GT2003BehaviorControl::execute(Time now, const BehaviorControlRequest& control, Debug& debug) {
  chooseAgent(debug);
  apply(control, debug);
  const bool record = debug.isActive(sendTrace);
  engine_->record(record ? &recorder_ : nullptr);
  debug.stopTime(engineTime, [&] { engine_->execute(now.ms); });
  for (const auto& [symbol, value] : control.outputs) engine_->setOutput(symbol, value);
  if (record) {
    std::string text;
    if (!recording_) {
      xabsl::TraceSubject subject = xabsl::TraceSubject::of(*engine_);
      nameAsInLogs(subject.model.files);
      text = toText(subject);
    }
    text += toText(recorder_.events());
    recorder_.clear();
    debug.out().write(now, BehaviorTrace{std::move(text)});
  }
  recording_ = record;
  if (debug.isActive(sendActivations)) debug.out().write(now, stateOf(*engine_, control.shown));
}

void GT2003BehaviorControl::update(WorldState world, const Behavior& behavior,
                                   const BehaviorControlRequest& control,
                                   MotionRequest& motionRequest, HeadControlMode& headControlMode,
                                   LedRequest& ledRequest, SoundRequest& soundRequest,
                                   BehaviorTeamMessage& message, Debug& debug) {
  if (behavior.compiled && behavior.compiled->shared() != loaded_)
    load(behavior, world.motions, debug);
  tactics_.update(world);

  movement_.begin();
  outputs_ = {};
  if (engine_) execute(world.frame.time, control, debug);

  if (const FieldPilot* pilot = movement_.pilot())
    if (auto canvas = debug.onField(drawField)) pilot->draw(canvas, world.field);

  motionRequest = motionRequest_;
  motionRequest.tail = outputs_.tail;
  motionRequest.time = world.frame.time;
  motionRequest.walkType = outputs_.manner.type;
  headControlMode = outputs_.head;
  ledRequest = outputs_.leds;
  soundRequest = outputs_.sound;
  message = tactics_.message();
}

}  // namespace gt
