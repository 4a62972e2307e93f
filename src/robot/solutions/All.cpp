#include "robot/Robot.h"
#include "robot/Solutions.h"

namespace gt {

const RobotModules& allModules() {
  static const RobotModules modules = [] {
    RobotModules all = tasks();
    addPerception(all);
    addModeling(all);
    addBehavior(all);
    addMotion(all);
    return all;
  }();
  return modules;
}

const SolutionTable& solutions() {
  return allModules().solutions;
}

const Vocabulary& robotVocabulary() {
  static const Vocabulary vocabulary{allModules().messageTypes()};
  return vocabulary;
}

Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths) {
  return loadConfiguration(paths, allModules());
}

Result<Plan> robotPlan(const Layout& layout,
                       const std::vector<const RepresentationType*>& platform) {
  return makePlan(layout, solutions(), platform, allModules().given());
}

Result<std::unique_ptr<Robot>> Robot::make(const RobotSetup& setup) {
  return make(setup, allModules());
}

}  // namespace gt
