#pragma once
#include <nanobind/nanobind.h>

namespace gt::python {

/// Environments: worlds in which agents act and are rewarded, for gt2003.envs.
void bindEnvironments(nanobind::module_& module);

}  // namespace gt::python
