#pragma once
#include <nanobind/nanobind.h>

namespace gt::python {

/// Match and Robot: scenes that run, and the robots in them.
void bindMatch(nanobind::module_& module);

}  // namespace gt::python
