#pragma once
#include <memory>
#include <optional>

#include "debug/Debug.h"
#include "framework/Module.h"
#include "modules/behavior/Tasks.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/behavior/control/BehaviorControlRequest.h"
#include "modules/behavior/control/SymbolSources.h"
#include "modules/behavior/skills/BasicBehaviors.h"
#include "modules/behavior/tactics/WorldState.h"
#include "representations/infrastructure/FrameInfo.h"
#include "xabsl/engine/Engine.h"

namespace gt {

/// Decides by executing a behavior written in XABSL (report 3.8). What the behavior may ask and say
/// is declared in behavior/; from there SoccerSymbols.h is generated, with a function for each
/// symbol and a class for each basic behavior, which SymbolSources.h and BasicBehaviors.h
/// implement.
class GT2003BehaviorControl {
 public:
  using Parameters = Movement::Parameters;
  Parameters parameters;

  GT2003BehaviorControl() = default;
  GT2003BehaviorControl(const GT2003BehaviorControl&) = delete;  // the symbols refer to it
  GT2003BehaviorControl& operator=(const GT2003BehaviorControl&) = delete;

  void update(const FrameInfo& frame, const Behavior& behavior,
              const BehaviorControlRequest& control, const Player& player,
              const FieldDimensions& field, const GameControlData& game, const RobotPose& self,
              const BallModel& ball, const TeamBallModel& teamBall, const ObstaclesModel& obstacles,
              const PlayersCollection& players, const RobotState& body, const TeamMessages& team,
              const MotionInfo& motion, const MotionNet& motions, MotionRequest& motionRequest,
              HeadControlMode& headControlMode, LedRequest& ledRequest,
              BehaviorTeamMessage& message, Debug& debug);

  /// The symbols, basic behaviors and special actions for a behavior to be linked with: to check
  /// one without a robot, too.
  const xabsl::Symbols& symbols(const MotionNet& motions);
  const std::optional<xabsl::Engine>& engine() const { return engine_; }

 private:
  void load(const Behavior& behavior, Debug& debug);
  void obey(const BehaviorControlRequest& control, Debug& debug);
  void execute(Time now, const BehaviorControlRequest& control, Debug& debug);

  WorldState world_;
  MotionRequest motionRequest_;
  DynamicRole role_ = DynamicRole::defensiveSupporter;
  SoccerInputs inputs_{world_, role_};
  SoccerOutputs outputs_;
  Movement movement_{world_, motionRequest_, parameters};
  BasicBehaviors basicBehaviors_{movement_};
  xabsl::Symbols symbols_;
  std::shared_ptr<const xabsl::Model> loaded_;  // kept, so that no other gets its address
  std::optional<xabsl::Engine> engine_;
  BehaviorControlRequest obeyed_;  ///< The request that the engine was told last.
  xabsl::TraceRecorder recorder_{10'000};
  bool recording_ = false;
};

}  // namespace gt
