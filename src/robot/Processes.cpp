#include "robot/Processes.h"

#include "modules/behavior/control/BehaviorControlRequest.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/OdometryData.h"

namespace gt {

const std::vector<const RepresentationType*>& platformRepresentations() {
  static const std::vector<const RepresentationType*> list{
      &representation<Image>(), &representation<SensorDataBuffer>(),
      &representation<GameControlData>(), &representation<TeamMessages>(),
      &representation<OracledWorldState>()};
  return list;
}

const std::vector<const RepresentationType*>& commandRepresentations() {
  static const std::vector<const RepresentationType*> list{
      &representation<JointData>(), &representation<OdometryData>(), &representation<LedValue>(),
      &representation<TeamMessage>()};
  return list;
}

const std::vector<const RepresentationType*>& givenRepresentations() {
  static const std::vector<const RepresentationType*> list = [] {
    std::vector<const RepresentationType*> types = Configuration::representations();
    types.push_back(&representation<Player>());
    types.push_back(&representation<FrameInfo>());
    types.push_back(&representation<BehaviorControlRequest>());
    return types;
  }();
  return list;
}

std::unique_ptr<ModuleProcess> makeProcess(const Plan::Process& plan, const RobotSetup& setup) {
  Blackboard blackboard;
  setup.configuration->share(blackboard, setup.address);
  blackboard.get<Player>() = setup.player;
  Time& frameTime = blackboard.get<FrameInfo>().time;
  return std::make_unique<ModuleProcess>(plan, std::move(blackboard), frameTime,
                                         Random{setup.seed});
}

Result<void> configureProcess(ModuleProcess& process, const Configuration& configuration) {
  for (const Configuration::SolutionChoice& choice : configuration.solutions)
    if (process.solves(choice.task))
      if (const auto done = process.request(SolutionRequest{choice.task, choice.solution}); !done)
        return Error{choice.file, choice.line, done.error().field, done.error().what};
  for (const Configuration::ParameterFile& file : configuration.parameters)
    if (process.solves(file.task))
      if (auto done = process.configure(file.task, file.solution, file.text, file.path); !done)
        return done;
  return {};
}

}  // namespace gt
