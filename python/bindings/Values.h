#pragma once
#include <nanobind/nanobind.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "streams/Type.h"

namespace gt::python {

namespace nb = nanobind;

/// A value as a Python object: records as objects of their class, enumerations as members of
/// theirs, vectors and arrays of scalars as NumPy arrays, other arrays and lists as lists.
nb::object toPython(ConstValue value);

/// The object of a value that changes: the same one again, as long as nobody else has kept it or a
/// part of it. What somebody has kept stays as it is, so that it is like a copy for all others.
class KeptObject {
 public:
  /// Sets it to a value, which always has the same type; `owners` references to it are known.
  const nb::object& set(ConstValue value, Py_ssize_t owners = 1);

  /// For Python's garbage collector: visits what it holds, and lets it go.
  int traverse(visitproc visit, void* arg) const;
  void clear();
  /// Lets it be: Python is gone.
  void abandon();

 private:
  void setPart(nb::handle record, nb::handle name, ConstValue value);

  nb::object object_;
  std::byte* numbers_ = nullptr;  ///< Of an array.
  std::vector<KeptObject> parts_;
};

/// Sets a value from a Python object as `toPython` makes it; a record also from a dict that names
/// some of its fields. Throws Failure, which names the path.
void fromPython(nb::handle object, Value value, std::string_view path);

/// A Python object as a text of the config format, for a flat type. Throws Failure.
std::string configText(nb::handle object, const Type& type, const std::string& path);

/// The value at a path below a record, array or list, such as "pose.translation.x". Throws Failure.
/// Appends the path with its fields as they are spelled in C++ to `spelled`.
ConstValue at(ConstValue root, std::string_view path, const std::string& whole,
              std::string* spelled = nullptr);

/// The first name of a path, and what follows its dot.
std::pair<std::string, std::string> splitPath(const std::string& path);

}  // namespace gt::python
