#pragma once
#include <nanobind/nanobind.h>

namespace gt::python {

/// Module: one solution of a task by itself; and the table of solutions.
void bindModules(nanobind::module_& module);

}  // namespace gt::python
