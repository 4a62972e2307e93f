#pragma once
#include <nanobind/nanobind.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/Representation.h"

namespace gt::python {

namespace nb = nanobind;

/// NumPy's name of a number's type, such as "float64".
std::string numberName(Number number);

/// How a type's scalars lie in a NumPy array: one number for each, and the shape.
struct Dense {
  const Type* scalar;              ///< A boolean, a number or an enumeration.
  std::vector<std::size_t> shape;  ///< Of one value.

  std::size_t bytes() const;
  /// NumPy's name of the scalars' type, such as "float64".
  std::string dtype() const;
};

/// Types whose values are arrays in Python: vectors (x, y, z), records of bytes (pixels), and
/// arrays of these and of scalars. Empty for all others, and for lists, whose length varies.
const std::optional<Dense>& denseOf(const Type& type);
/// The same for an element of an array or list; scalars have the shape ().
std::optional<Dense> denseElementOf(const Type& sequence);

/// The Python class of records and enumerations, and what is needed to make objects of it.
struct PythonClass {
  nb::handle type;
  std::vector<nb::handle> names;    ///< Of records: the attributes, in the order of the parts.
  std::vector<nb::handle> members;  ///< Of enumerations, by their numbers.
};

/// The representations and messages of all modules, those of matches, and
/// what only logs have, by name.
const std::map<std::string, const RepresentationType*>& knownRepresentations();
/// The class of a record or an enumeration, which gt2003.representations has made.
const PythonClass& classOf(const Type& type);

/// Functions by which the package makes its classes.
void bindTypes(nb::module_& module);

}  // namespace gt::python
