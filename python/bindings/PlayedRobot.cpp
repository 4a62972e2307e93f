#include "PlayedRobot.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <set>

#include "Failure.h"
#include "Values.h"
#include "base/Lines.h"
#include "base/Suggestion.h"
#include "framework/UnknownNames.h"
#include "robot/Solutions.h"

namespace gt::python {
namespace {

namespace nb = nanobind;

static_assert(sizeof(Pixel) == 4 && sizeof(ColorClass) == 1 && sizeof(int) == 4);

/// A view of a plane of numbers that belong to `owner`.
template <typename N>
nb::object planeOf(const void* data, const CameraInfo& info, const nb::object& owner) {
  const std::size_t shape[] = {static_cast<std::size_t>(info.height),
                               static_cast<std::size_t>(info.width)};
  return nb::ndarray<nb::numpy, const N>(data, 2, shape, owner).cast();
}

std::vector<std::string> parameterNames(ModuleProcess& process, const std::string& task,
                                        const std::string& solution) {
  std::vector<std::string> names;
  for (const TaskDescription& described : process.describe(task).tasks)
    for (const SolutionDescription& known : described.solutions)
      if (known.name == solution)
        for (const ParameterDescription& parameter : known.parameters)
          names.push_back(parameter.path);
  return names;
}

}  // namespace

ModuleProcess& PlayedRobot::solving(const std::string& task) const {
  for (const auto& process : robot().robot().processes())
    if (process->solves(task)) return *process;
  std::vector<std::string> known = representations();
  for (const auto& [name, described] : gt::solutions().tasks()) known.push_back(name);
  throw Failure{
      Error{.field = task,
            .what = "the robot has no such representation or task" + suggestion(task, known)}};
}

ConstValue PlayedRobot::parameterAt(const std::string& path) const {
  const auto [task, rest] = splitPath(path);
  ModuleProcess& process = solving(task);
  const auto [first, behind] = splitPath(rest);
  const Task* known = gt::solutions().find(task);
  const bool named = known && known->find(first);
  auto value =
      named ? process.parameterValue(task, first, behind) : process.parameterValue(task, "", rest);
  if (value) return *value;
  const auto parameters =
      parameterNames(process, task, named ? first : process.activeSolution(task));
  throw Failure{Error{.field = path,
                      .what = value.error().what + suggestion(named ? behind : rest, parameters)}};
}

ConstValue PlayedRobot::valueAt(const std::string& path, std::string* spelled) const {
  const auto [representation, rest] = splitPath(path);
  const auto value = robot().robot().value(representation);
  if (spelled) *spelled = value ? representation : path;
  return value ? at(*value, rest, path, spelled) : parameterAt(path);
}

nb::object PlayedRobot::get(const std::string& path) const {
  return toPython(valueAt(path));
}

void PlayedRobot::set(const std::string& path, nb::handle value) const {
  std::string spelled;
  const ConstValue now = valueAt(path, &spelled);
  setFields(spelled, value, now.type());
}

void PlayedRobot::setFields(const std::string& path, nb::handle value, const Type& type) const {
  if (isFlat(type)) {
    const std::string text = configText(value, type, path);
    if (text.empty()) throw Failure{Error{.field = path, .what = "expected at least one element"}};
    execute("set " + quotedWord(path) + " " + text, path);
    return;
  }
  if (type.kind != Kind::record)
    throw Failure{Error{.field = path, .what = "is a list; set its elements"}};
  for (const Part& part : type.parts) {
    const std::string field{part.name};
    if (!nb::hasattr(value, field.c_str()))
      throw Failure{Error{.field = path, .what = "expected a " + std::string{type.name}}};
    setFields(path + "." + field, value.attr(field.c_str()), part.type());
  }
}

std::vector<std::string> PlayedRobot::representations() const {
  std::set<std::string> names;
  for (const auto& process : robot().robot().processes())
    for (const RepresentationType* type : process->blackboard().types())
      if (type->type() && robot().robot().value(type->name)) names.emplace(type->name);
  return {names.begin(), names.end()};
}

std::map<std::string, std::string> PlayedRobot::solutions() const {
  std::map<std::string, std::string> active;
  for (const auto& [task, known] : gt::solutions().tasks())
    for (const auto& process : robot().robot().processes())
      if (process->solves(task)) active[task] = process->activeSolution(task);
  return active;
}

nb::object PlayedRobot::solve(const std::string& task, nb::handle solution) const {
  return match_->solve(index_, task, solution);
}

void PlayedRobot::execute(const std::string& line, const std::string& about) const {
  match_->executeFor(name(), line, about);
}

nb::dict PlayedRobot::times() const {
  nb::dict all;
  for (const auto& process : robot().robot().processes())
    for (const Stopwatch& watch : process->times())
      all[watch.name.c_str()] = toPython(valueOf(watch));
  return all;
}

nb::dict PlayedRobot::parameters(const std::string& task, const std::string& solution) const {
  ModuleProcess& process = solving(task);
  const std::string wanted = solution.empty() ? process.activeSolution(task) : solution;
  nb::dict values;
  for (const TaskDescription& described : process.describe(task).tasks)
    for (const SolutionDescription& known : described.solutions)
      if (known.name == wanted) {
        for (const ParameterDescription& parameter : known.parameters)
          values[parameter.path.c_str()] =
              toPython(*process.parameterValue(task, wanted, parameter.path));
        return values;
      }
  throw Failure{Error{.field = task, .what = noSuchSolution(*gt::solutions().find(task), wanted)}};
}

nb::object PlayedRobot::image() const {
  const Image& image = match_->match().simulation().image(inSimulation());
  if (image.pixels.empty()) return nb::none();
  const auto width = static_cast<std::int64_t>(image.info.width);
  const std::size_t shape[] = {static_cast<std::size_t>(image.info.height),
                               static_cast<std::size_t>(image.info.width), 3};
  const std::int64_t strides[] = {4 * width, 4, 1};
  return nb::ndarray<nb::numpy, const std::uint8_t>(&image.pixels.front().y, 3, shape, owner_,
                                                    strides)
      .cast();
}

nb::object PlayedRobot::labels() const {
  const Simulation& simulation = match_->match().simulation();
  if (!match_->keepsLabels())
    throw Failure{Error{.field = "labels", .what = "make the match with labels=True"}};
  const ImageTruth* truth = simulation.truth(inSimulation());
  if (!truth) return nb::none();
  const CameraInfo& info = simulation.image(inSimulation()).info;
  return nb::make_tuple(planeOf<std::uint8_t>(truth->classes.data(), info, owner_),
                        planeOf<std::int32_t>(truth->geoms.data(), info, owner_));
}

nb::object PlayedRobot::truePose() const {
  return toPython(valueOf(match_->match().simulation().world().robot(inSimulation()).pose));
}

}  // namespace gt::python
