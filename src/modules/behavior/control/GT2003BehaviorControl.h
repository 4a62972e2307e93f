#pragma once
#include <memory>
#include <optional>

#include "debug/Debug.h"
#include "framework/Module.h"
#include "modules/behavior/Tasks.h"
#include "modules/behavior/control/Behavior.h"
#include "modules/behavior/control/SymbolSources.h"
#include "modules/behavior/skills/BasicBehaviors.h"
#include "modules/behavior/tactics/WorldState.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "xabsl/engine/Engine.h"

namespace gt {

/// Solution *GT2003* of BehaviorControl: executes a behavior written in XABSL (report 3.8). The
/// input and output symbols of the behavior are declared in behavior/. From them SoccerSymbols.h is
/// generated, with a function for each symbol and a class for each basic behavior, which
/// SymbolSources.h and BasicBehaviors.h implement.
class GT2003BehaviorControl {
 public:
  struct Parameters {
    std::string agent;
    Movement::Parameters movement;
    Tactics::Parameters tactics;

    static constexpr auto fields() {
      return Fields{field<&Parameters::agent>(
                        "name of the agent that is executed; empty: the behavior's first one"),
                    field<&Parameters::movement>(), field<&Parameters::tactics>()};
    }
  };
  Parameters parameters;

  GT2003BehaviorControl() = default;
  GT2003BehaviorControl(const GT2003BehaviorControl&) = delete;  // the symbols refer to it
  GT2003BehaviorControl& operator=(const GT2003BehaviorControl&) = delete;

  /// Provides the requests of the behavior in this cycle and the message to the teammates. Without
  /// a behavior the robot stands and looks at nothing. The behavior is executed in each cycle,
  /// whether or not there is a new image; it must check the age of the models itself.
  void update(WorldState world, const Behavior& behavior, const BehaviorControlRequest& control,
              MotionRequest& motionRequest, HeadControlMode& headControlMode,
              LedRequest& ledRequest, SoundRequest& soundRequest, BehaviorTeamMessage& message,
              Debug& debug);

  /// The symbols, basic behaviors and special actions with which a behavior is linked, also to
  /// check one without a robot.
  const xabsl::Symbols& symbols(const MotionNet& motions);
  const std::optional<xabsl::Engine>& engine() const { return engine_; }

 private:
  void load(const Behavior& behavior, const MotionNet& motions, Debug& debug);
  void chooseAgent(Debug& debug);
  void apply(const BehaviorControlRequest& control, Debug& debug);
  void execute(Time now, const BehaviorControlRequest& control, Debug& debug);

  Tactics tactics_{parameters.tactics};
  MotionRequest motionRequest_;
  SoccerInputs inputs_{tactics_};
  SoccerOutputs outputs_;
  Movement movement_{tactics_, motionRequest_, outputs_.manner, parameters.movement};
  BasicBehaviors basicBehaviors_{movement_};
  xabsl::Symbols symbols_;
  std::shared_ptr<const xabsl::Model> loaded_;  // kept, so that its address is not reused
  std::optional<xabsl::Engine> engine_;
  BehaviorControlRequest applied_;  ///< The request that was applied last.
  xabsl::TraceRecorder recorder_{10'000};
  std::string agent_;  ///< The agent chosen last.
  bool recording_ = false;
};
static_assert(complete<GT2003BehaviorControl::Parameters>);

}  // namespace gt
