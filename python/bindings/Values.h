#pragma once
#include <nanobind/nanobind.h>

#include <string>
#include <string_view>

#include "streams/Type.h"

namespace gt::python {

namespace nb = nanobind;

/// A value as a Python object: records as objects of their class, enumerations as members of
/// theirs, vectors and arrays of scalars as NumPy arrays, other arrays and lists as lists.
nb::object toPython(ConstValue value);

/// Sets a value from a Python object as `toPython` makes it; a record also from a dict that names
/// some of its fields. Throws Failure, which names the path.
void fromPython(nb::handle object, Value value, const std::string& path);

/// A Python object as a text of the config format, for a flat type. Throws Failure.
std::string configText(nb::handle object, const Type& type, const std::string& path);

/// The value at a path below a record, array or list, such as "pose.translation.x". Throws Failure.
ConstValue at(ConstValue root, std::string_view path, const std::string& whole);

/// The first name of a path, and what follows its dot.
std::pair<std::string, std::string> splitPath(const std::string& path);

}  // namespace gt::python
