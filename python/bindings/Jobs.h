#pragma once
#include <nanobind/nanobind.h>

namespace gt::python {

/// Experiments and their jobs, for gt2003.jobs.
void bindJobs(nanobind::module_& module);

}  // namespace gt::python
