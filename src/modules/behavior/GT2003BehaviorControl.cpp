#include "modules/behavior/GT2003BehaviorControl.h"

#include "representations/behavior/BehaviorTrace.h"
#include "xabsl/trace/TraceFile.h"

namespace gt {
namespace {

const DebugKey sendActivations{"BehaviorControl/activations"};
const DebugKey sendTrace{"BehaviorControl/trace"};

}  // namespace

const xabsl::Symbols& GT2003BehaviorControl::symbols() {
  if (symbols_.inputs().empty()) soccer::registerSymbols(symbols_, inputs_, outputs_, skills_);
  return symbols_;
}

void GT2003BehaviorControl::load(const Behavior& behavior, Debug& debug) {
  loaded_ = behavior.compiled->shared();
  auto creation = xabsl::Engine::create(*behavior.compiled, symbols());
  for (const xabsl::Diagnostic& diagnostic : creation.diagnostics) debug.text(toString(diagnostic));
  if (!creation.engine) return;
  if (engine_) creation.engine->goOnFrom(*engine_);
  engine_ = std::move(creation.engine);
  recording_ = false;
}

/// What the trace is about comes first, once; then each cycle by itself.
void GT2003BehaviorControl::execute(Time now, Debug& debug) {
  const bool record = debug.isActive(sendTrace);
  engine_->record(record ? &recorder_ : nullptr);
  engine_->execute(now.ms);
  if (record) {
    std::string text;
    if (!recording_) text = toText(xabsl::TraceSubject::of(*engine_));
    text += toText(recorder_.events());
    recorder_.clear();
    debug.out().write(now, BehaviorTrace{std::move(text)});
  }
  recording_ = record;
  if (debug.isActive(sendActivations)) debug.text(xabsl::toString(engine_->activations()));
}

void GT2003BehaviorControl::update(const FrameInfo& frame, const Behavior& behavior,
                                   const Player& player, const FieldDimensions& field,
                                   const GameControlData& game, const RobotPose& self,
                                   const BallModel& ball, const TeamBallModel& teamBall,
                                   const RobotState& body, const TeamMessages& team,
                                   const MotionInfo& motion, MotionRequest& motionRequest,
                                   HeadControlMode& headControlMode, LedRequest& ledRequest,
                                   BehaviorTeamMessage& message, Debug& debug) {
  if (behavior.compiled && behavior.compiled->shared() != loaded_) load(behavior, debug);
  world_ = {frame.time, player, field, game, self, ball, teamBall, body, team, motion};
  role_ = negotiateRole(world_, role_);

  skills_.stand();
  outputs_ = {};
  if (engine_) execute(frame.time, debug);

  motionRequest = motionRequest_;
  motionRequest.time = frame.time;
  headControlMode = outputs_.head;
  ledRequest = outputs_.leds;
  message = {role_, estimatedTimeToReachBall(world_)};
}

}  // namespace gt
