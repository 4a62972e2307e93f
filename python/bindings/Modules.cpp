#include "Modules.h"

#include <nanobind/stl/string.h>

#include "PlayedModule.h"
#include "robot/Solutions.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

nb::list portsOf(const Solution& solution, bool outputs) {
  nb::list names;
  for (const Port& port : solution.ports)
    if (port.type->type() && (port.kind == PortKind::output) == outputs)
      names.append(std::string{port.type->name});
  return names;
}

/// For each task its solutions, the first is the default, with the representations that they read
/// and provide.
nb::dict describeSolutions() {
  nb::dict tasks;
  for (const auto& [name, task] : solutions().tasks()) {
    nb::dict all;
    for (const Solution& solution : task.solutions)
      all[solution.name.c_str()] =
          nb::make_tuple(portsOf(solution, false), portsOf(solution, true));
    tasks[name.c_str()] = all;
  }
  return tasks;
}

}  // namespace

void bindModules(nb::module_& module) {
  module.def("_solutions", &describeSolutions);
  module.def("_input_name", [](const std::string& type) { return snakeCase(type); });
  nb::class_<PlayedModule>(module, "Module", "One solution of a task by itself.")
      .def(nb::init<const std::string&, const std::string&, std::uint64_t, const std::string&>(),
           "task"_a, "solution"_a, nb::kw_only(), "seed"_a = 1, "root"_a = "")
      .def(
          "update", &PlayedModule::update,
          nb::sig("def update(self, **inputs: typing.Any) -> typing.Any"),
          "Sets inputs by the names of their representations in lower case with underscores\n"
          "(`landmarks_percept`), as objects or as dicts of some fields; those that are not given\n"
          "keep their values. Runs once. Returns the output, or a tuple of several.")
      .def("get", &PlayedModule::get, "path"_a, nb::sig("def get(self, path: str) -> typing.Any"),
           "A parameter by its path.")
      .def("set", &PlayedModule::set, "path"_a, "value"_a.none(),
           nb::sig("def set(self, path: str, value: typing.Any) -> None"), "Sets a parameter.")
      .def_prop_ro("parameters", &PlayedModule::parameters,
                   nb::sig("def parameters(self) -> dict[str, typing.Any]"),
                   "All parameters by path.")
      .def_prop_ro("task", &PlayedModule::task)
      .def_prop_ro("solution", &PlayedModule::solution);
}

}  // namespace gt::python
