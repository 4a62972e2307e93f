#include "robot/Processes.h"

#include <algorithm>

#include "colors/HsiColors.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

std::vector<const RepresentationType*> configurationOf(const ProcessLayout& process,
                                                       const SolutionTable& table) {
  std::vector<const RepresentationType*> types{&representation<CameraSettings>()};
  for (const ProcessLayout::Group& group : process.groups)
    for (const std::string& name : group.tasks)
      if (const Task* task = table.find(name))
        for (const Solution& solution : task->solutions)
          for (const Port& port : solution.ports) types.push_back(port.type);
  // Tools ask of which ranges the color table was made.
  if (std::ranges::find(types, &representation<ColorTable64>()) != types.end())
    types.push_back(&representation<HsiColors>());
  return types;
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
        return Error{.file = choice.file,
                     .line = choice.line,
                     .field = done.error().field,
                     .what = done.error().what};
  for (const Configuration::ParameterFile& file : configuration.parameters)
    if (process.solves(file.task))
      if (auto done = process.configure(file.task, file.solution, file.text, file.path); !done)
        return done;
  return {};
}

}  // namespace gt
