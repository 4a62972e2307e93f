#pragma once
#include <nanobind/nanobind.h>

namespace gt::python {

/// LogFile: what gt2003.logs makes arrays of.
void bindLogs(nanobind::module_& module);

}  // namespace gt::python
