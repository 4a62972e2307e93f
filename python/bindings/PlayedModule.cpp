#include "PlayedModule.h"

#include <nanobind/stl/string.h>

#include <algorithm>

#include "Failure.h"
#include "Root.h"
#include "Values.h"
#include "base/Suggestion.h"
#include "framework/UnknownNames.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Image.h"
#include "robot/Configuration.h"
#include "robot/Solutions.h"

namespace gt::python {
namespace {

template <typename Known>
std::string listOf(const Known& known) {
  std::string text;
  for (const auto& name : known) text += (text.empty() ? "" : " | ") + name;
  return text;
}

const Task& taskOf(const std::string& name) {
  if (const Task* task = solutions().find(name)) return *task;
  throw Failure{Error{.field = name, .what = noSuchTask(solutions(), name)}};
}

const Solution& solutionOf(const Task& task, const std::string& name) {
  if (const Solution* solution = task.find(name)) return *solution;
  std::vector<std::string> known;
  for (const Solution& solution : task.solutions) known.push_back(solution.name);
  throw Failure{Error{.field = task.name,
                      .what = "there is no solution '" + name + "', only " + listOf(known) +
                              suggestion(name, known)}};
}

std::vector<const RepresentationType*> typesOf(const Solution& solution) {
  std::vector<const RepresentationType*> types;
  for (const Port& port : solution.ports) types.push_back(port.type);
  return types;
}

}  // namespace

std::string inputName(const RepresentationType& type) {
  return snakeCase(type.name);
}

PlayedModule::PlayedModule(const std::string& task, const std::string& solution, std::uint64_t seed,
                           const std::string& root)
    : task_{&taskOf(task)}, solution_{&solutionOf(*task_, solution)} {
  const auto paths = ConfigurationPaths::in(findRoot(root));
  const auto wanted = typesOf(*solution_);
  const auto configuration = orThrow(loadConfiguration(paths, allModules(), &wanted));
  configuration->share(blackboard_, "");
  module_ = solution_->make({blackboard_, debug_, Random{seed}.fork(task)});
  for (const Configuration::ParameterFile& file : configuration->parameters)
    if (file.task == task && file.solution == solution)
      orThrow(module_->configure(file.text, file.path).firstError());
}

nb::object PlayedModule::update(const nb::kwargs& inputs) {
  for (const auto& [key, object] : inputs) {
    const auto name = nb::cast<std::string>(key);
    const auto port = std::ranges::find_if(solution_->ports, [&](const Port& p) {
      return p.kind != PortKind::output && p.type->type() && inputName(*p.type) == name;
    });
    if (port == solution_->ports.end()) {
      std::vector<std::string> known;
      for (const Port& p : solution_->ports)
        if (p.kind != PortKind::output && p.type->type()) known.push_back(inputName(*p.type));
      throw Failure{
          Error{.field = name, .what = solution() + " has no such input, only " + listOf(known)}};
    }
    const RepresentationType& type = *port->type;
    const auto value = type.make();
    type.copy(blackboard_.get(type), value.get());
    fromPython(object, {type.type(), value.get()}, name);
    if (const auto valid = checked(ConstValue{*type.type(), value.get()}); !valid)
      throw Failure{Error{.field = name + "." + valid.error().field, .what = valid.error().what}};
    type.copy(value.get(), blackboard_.own(type));
  }
  requireImage();
  debug_.begin(blackboard_.get<FrameInfo>().time);
  module_->run();
  debug_.out().clear();
  nb::list outputs;
  for (const Port& port : solution_->ports)
    if (port.kind == PortKind::output)
      outputs.append(toPython({*port.type->type(), blackboard_.get(*port.type)}));
  return nb::len(outputs) == 1 ? nb::object{outputs[0]} : nb::object{nb::tuple(outputs)};
}

void PlayedModule::requireImage() {
  const auto reads = [](const Port& port) { return port.type == &representation<Image>(); };
  if (std::ranges::any_of(solution_->ports, reads) && blackboard_.get<Image>().pixels.empty())
    throw Failure{Error{.field = "image", .what = solution() + " needs one with pixels"}};
}

ConstValue PlayedModule::parameter(const std::string& path) {
  const auto all = module_->parameters();
  const auto found = std::ranges::find(all, path, &PathInfo::path);
  if (found == all.end())
    throw Failure{Error{.field = path, .what = "the module has no such parameter"}};
  return found->value;
}

nb::object PlayedModule::get(const std::string& path) {
  return toPython(parameter(path));
}

void PlayedModule::set(const std::string& path, nb::handle value) {
  orThrow(module_->set(path, configText(value, parameter(path).type(), path)));
}

nb::dict PlayedModule::parameters() {
  nb::dict values;
  for (const PathInfo& parameter : module_->parameters())
    values[parameter.path.c_str()] = toPython(parameter.value);
  return values;
}

}  // namespace gt::python
