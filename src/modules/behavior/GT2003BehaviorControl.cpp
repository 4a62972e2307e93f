#include "modules/behavior/GT2003BehaviorControl.h"

#include <string>
#include <vector>

namespace gt {
namespace {

const DebugKey sendActivations{"BehaviorControl/activations"};

/// An enumerator as XABSL spells it: searchForBall is search_for_ball. A suffix keeps clear of
/// XABSL's own words.
template <typename E>
std::vector<std::string> xabslNames(const std::string& suffix = {}) {
  std::vector<std::string> list;
  for (const std::string_view name : enumNames<E>) {
    std::string& spelled = list.emplace_back();
    for (const char c : name) {
      if (c >= 'A' && c <= 'Z') spelled += '_';
      spelled += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    spelled += suffix;
  }
  return list;
}

}  // namespace

void GT2003BehaviorControl::registerBall() {
  const WorldState& w = world_;
  symbols_.input("ball.seen.x", [&w] { return w.ball.position.x(); });
  symbols_.input("ball.seen.y", [&w] { return w.ball.position.y(); });
  symbols_.input("ball.seen.distance", [&w] { return w.ball.position.norm(); });
  symbols_.input("ball.seen.angle", [&w] { return toDegrees(angleOf(w.ball.position)); });
  symbols_.input("ball.time_since_last_seen",
                 [&w] { return static_cast<double>(w.now - w.ball.lastSeen); });
  symbols_.input("ball.consecutive_time_seen",
                 [&w] { return static_cast<double>(w.ball.consecutiveTimeSeen); });
  symbols_.input("ball.known.x", [&w] { return w.knownBallOnField().x(); });
  symbols_.input("ball.known.y", [&w] { return w.knownBallOnField().y(); });
  symbols_.input("ball.known.distance", [&w] { return w.knownBall().norm(); });
  symbols_.input("ball.known.angle", [&w] { return toDegrees(angleOf(w.knownBall())); });
  symbols_.input("ball.time_since_last_known",
                 [&w] { return static_cast<double>(w.knownBallAge()); });
  symbols_.input("ball.kick_direction", [&w] { return toDegrees(kickDirection(w)); });
  symbols_.input("ball.kick_angle",
                 [&w] { return toDegrees(normalize(kickDirection(w) - w.self.pose.rotation)); });
  symbols_.input("ball.kick_tolerance", [&w] { return toDegrees(kickTolerance(w)); });
  symbols_.input("ball.angle_around", {"facing"}, [&w](double facing) {
    return toDegrees(
        normalize(angleOf(w.knownBall()) + w.self.pose.rotation - fromDegrees(facing)));
  });
}

void GT2003BehaviorControl::registerSelf() {
  const WorldState& w = world_;
  symbols_.input("robot_pose.x", [&w] { return w.self.pose.translation.x(); });
  symbols_.input("robot_pose.y", [&w] { return w.self.pose.translation.y(); });
  symbols_.input("robot_pose.angle", [&w] { return toDegrees(w.self.pose.rotation); });
  symbols_.input("robot_pose.validity", [&w] { return w.self.validity; });
  symbols_.input("robot_pose.distance_to", {"x", "y"}, [&w](double x, double y) {
    return (w.self.pose.translation - Vector2d{x, y}).norm();
  });
  symbols_.input("body.fallen", [&w] { return w.body.state == BodyState::fallen; });
  symbols_.input("motion.special_action", [&w] {
    return w.motion.executed.type == MotionType::specialAction ? w.motion.executed.specialAction
                                                               : SpecialAction::none;
  });
}

void GT2003BehaviorControl::registerGame() {
  const WorldState& w = world_;
  symbols_.input("game.state", [&w] { return w.game.state; });
  symbols_.input("game.own_kick_off", [&w] { return w.game.kickOff == KickOff::own; });
  symbols_.input("game.time_since_last_change",
                 [&w] { return static_cast<double>(w.now - w.game.timeOfLastChange); });
  symbols_.input("player.role", [&w] { return w.player.role; });
  symbols_.input("team.role", [this] { return role_; });
  symbols_.input("field.x_groundline", [&w] { return w.field.xGroundline; });
  symbols_.input("field.y_sideline", [&w] { return w.field.ySideline; });
  symbols_.input("min", {"a", "b"}, [](double a, double b) { return std::min(a, b); });
  symbols_.input("max", {"a", "b"}, [](double a, double b) { return std::max(a, b); });
  symbols_.input("abs", {"a"}, [](double a) { return std::abs(a); });
}

void GT2003BehaviorControl::registerOutputs() {
  symbols_.output("head_control_mode", &headControlMode_.mode);
  for (const Led led : {Led::lowerLeft, Led::middleLeft, Led::upperLeft, Led::lowerRight,
                        Led::middleRight, Led::upperRight, Led::top, Led::tailBlue, Led::tailRed})
    symbols_.output("led." + xabslNames<Led>()[static_cast<std::size_t>(led)],
                    &ledRequest_.modes[led]);
}

void GT2003BehaviorControl::registerBasicBehaviors() {
  symbols_.behavior("stand", [this] { skills_.stand(); });
  symbols_.behavior("getup", [this] { skills_.getup(); });
  symbols_.behavior("walk", {"x", "y", "turn"},
                    [this](double x, double y, double turn) { skills_.walk(x, y, turn); });
  symbols_.behavior("perform_special_action", {"id"},
                    [this](SpecialAction action) { skills_.specialAction(action); });
  symbols_.behavior("go_to_point", {"x", "y", "angle", "max_speed"},
                    [this](double x, double y, double angle, double maxSpeed) {
                      skills_.goToPoint(x, y, angle, maxSpeed);
                    });
  symbols_.behavior("go_to_ball", {"direction", "x", "y"},
                    [this](double angle, double x, double y) { skills_.goToBall(angle, x, y); });
}

void GT2003BehaviorControl::registerSymbols() {
  symbols_.enumeration<GameState>("game_state", xabslNames<GameState>("_state"));
  symbols_.enumeration<PlayerRole>("player_role", xabslNames<PlayerRole>());
  symbols_.enumeration<DynamicRole>("dynamic_role", xabslNames<DynamicRole>());
  symbols_.enumeration<SpecialAction>("special_action", xabslNames<SpecialAction>());
  symbols_.enumeration<HeadMode>("head_mode", xabslNames<HeadMode>());
  symbols_.enumeration<LedMode>("led_mode", xabslNames<LedMode>());
  registerBall();
  registerSelf();
  registerGame();
  registerOutputs();
  registerBasicBehaviors();
}

const xabsl::Symbols& GT2003BehaviorControl::symbols() {
  if (!registered_) registerSymbols();
  registered_ = true;
  return symbols_;
}

void GT2003BehaviorControl::load(const Behavior& behavior, Debug& debug) {
  loaded_ = behavior.compiled->shared();
  auto creation = xabsl::Engine::create(*behavior.compiled, symbols());
  for (const xabsl::Diagnostic& diagnostic : creation.diagnostics) debug.text(toString(diagnostic));
  if (creation.engine) engine_ = std::move(creation.engine);
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
  headControlMode_ = {};
  ledRequest_ = {};
  if (engine_) engine_->execute(frame.time.ms);

  motionRequest = motionRequest_;
  motionRequest.time = frame.time;
  headControlMode = headControlMode_;
  ledRequest = ledRequest_;
  message = {role_, estimatedTimeToReachBall(world_)};
  if (engine_ && debug.keys().isActive(sendActivations, frame.time))
    debug.text(xabsl::toString(engine_->activations()));
}

}  // namespace gt
