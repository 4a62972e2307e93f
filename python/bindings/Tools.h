#pragma once
#include <nanobind/nanobind.h>

namespace gt::python {

/// What gt2003.xabsl, gt2003.motions and gt2003.colors are made of.
void bindXabsl(nanobind::module_& module);
void bindMotions(nanobind::module_& module);
void bindColors(nanobind::module_& module);

}  // namespace gt::python
