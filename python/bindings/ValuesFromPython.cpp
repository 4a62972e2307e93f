#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "ValueParts.h"
#include "Values.h"
#include "base/Lines.h"

namespace gt::python {
namespace {

std::string typeNameOf(nb::handle object) {
  return nb::cast<std::string>(object.type().attr("__name__"));
}

[[noreturn]] void unexpected(const Place& place, const std::string& expected, nb::handle object) {
  fail(place, "expected " + expected + ", got " + typeNameOf(object));
}

bool isAnyBool(nb::handle object) {
  if (PyBool_Check(object.ptr())) return true;
  if (PyFloat_CheckExact(object.ptr()) || PyLong_CheckExact(object.ptr())) return false;
  return typeNameOf(object) == "bool_" || typeNameOf(object) == "bool";
}

template <typename N>
void storeNumber(nb::handle object, void* data, const Place& place) {
  N n{};
  if constexpr (std::is_floating_point_v<N>) {
    const double number = PyFloat_AsDouble(object.ptr());
    if (PyErr_Occurred()) {
      PyErr_Clear();
      unexpected(place, "a number", object);
    }
    if (!std::isfinite(number)) fail(place, "expected a finite number");
    n = static_cast<N>(number);
  } else {
    const nb::object whole = nb::steal(PyNumber_Index(object.ptr()));
    if (!whole.is_valid()) {
      PyErr_Clear();
      unexpected(place, "a whole number", object);
    }
    if (!nb::try_cast<N>(whole, n))
      fail(place, "is out of the range of its type: " + nb::cast<std::string>(nb::str(whole)));
  }
  std::memcpy(data, &n, sizeof n);
}

void scalarFromPython(nb::handle object, Value value, const Place& place) {
  const Type& type = *value.type;
  if (type.kind == Kind::boolean) {
    if (!isAnyBool(object)) unexpected(place, "a bool", object);
    setOrdinal(value, PyObject_IsTrue(object.ptr()));
  } else if (type.kind == Kind::number) {
    if (isAnyBool(object)) unexpected(place, "a number", object);
    withType(type.number,
             [&]<typename N>(std::type_identity<N>) { storeNumber<N>(object, value.data, place); });
  } else if (type.kind == Kind::text) {
    if (!nb::isinstance<nb::str>(object)) unexpected(place, "a str", object);
    if (const auto done = setScalar(value, nb::cast<std::string>(object)); !done)
      fail(place, done.error().what);
  } else if (nb::isinstance<nb::str>(object)) {
    if (const auto done = setScalar(value, nb::cast<std::string>(object)); !done)
      fail(place, done.error().what);
  } else {
    const PythonClass& known = classOf(type);
    const bool member = PyObject_IsInstance(object.ptr(), known.type.ptr()) == 1;
    if (!member) unexpected(place, "a " + std::string{type.name} + " or its name", object);
    setOrdinal(value, nb::cast<std::int64_t>(nb::int_(object)));
  }
}

void setFromPython(nb::handle object, Value value, const Place& place);

using Array = nb::ndarray<nb::numpy, nb::ro, nb::c_contig, nb::device::cpu>;

/// A Python object as an array of a type and shape, in which -1 is any length.
Array arrayOf(nb::handle object, const Dense& dense, bool anyLength, const Place& place) {
  nb::list shape;
  for (std::size_t i = 0; i < dense.shape.size(); ++i)
    shape.append(anyLength && i == 0 ? nb::object{nb::none()}
                                     : nb::object{nb::int_(dense.shape[i])});
  try {
    const nb::object as = nb::module_::import_("gt2003._arrays").attr("as_array");
    return nb::cast<Array>(as(object, dense.dtype(), nb::tuple(shape)));
  } catch (nb::python_error& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw;
    fail(place, nb::cast<std::string>(nb::str(error.value())));
  }
}

/// Copies an array that is already as it has to be: of float64, of this shape, finite, and not
/// empty. Most are; the others take longer.
bool copyDoubles(nb::handle object, Value value, const Dense& dense) {
  if (dense.scalar->kind != Kind::number || dense.scalar->number != Number::float64) return false;
  Py_buffer view;
  if (PyObject_GetBuffer(object.ptr(), &view, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) != 0) {
    PyErr_Clear();
    return false;
  }
  const auto* numbers = static_cast<const double*>(view.buf);
  const auto count = static_cast<std::size_t>(view.len) / sizeof(double);
  const bool fits =
      view.format && std::string_view{view.format} == "d" && count > 0 &&
      std::equal(dense.shape.begin(), dense.shape.end(), view.shape, view.shape + view.ndim,
                 [](std::size_t a, Py_ssize_t b) { return std::cmp_equal(a, b); }) &&
      std::all_of(numbers, numbers + count, [](double n) { return std::isfinite(n); });
  if (fits) {
    auto* place = static_cast<std::byte*>(view.buf);
    forEachScalar(value, place, [](std::byte* to, const std::byte* from, std::size_t n) {
      std::memcpy(to, from, n);
    });
  }
  PyBuffer_Release(&view);
  return fits;
}

void arrayFromPython(nb::handle object, Value value, const Dense& dense, const Place& place) {
  if (copyDoubles(object, value, dense)) return;
  const bool list = value.type->kind == Kind::list;
  const Array array = arrayOf(object, dense, list, place);
  if (list) value.type->resize(value.data, array.shape(0));
  // Only read: what visits it copies from there.
  auto* from = const_cast<std::byte*>(static_cast<const std::byte*>(array.data()));
  const auto names = static_cast<std::int64_t>(dense.scalar->names.size());
  if (dense.scalar->kind == Kind::enumeration) {
    const std::byte* at = from;
    for (std::size_t i = 0; i < array.size(); ++i, at += numberSize(dense.scalar->number)) {
      const std::int64_t number = ordinal(ConstValue{*dense.scalar, at});
      if (number < 0 || number >= names)
        fail(place, "has a value that is no " + std::string{dense.scalar->name} + ": " +
                        std::to_string(number));
    }
  }
  forEachScalar(value, from, [](std::byte* to, const std::byte* number, std::size_t n) {
    std::memcpy(to, number, n);
  });
}

void recordFromPython(nb::handle object, Value value, const Place& place) {
  const Type& type = *value.type;
  if (nb::isinstance<nb::dict>(object)) {
    for (const auto& [key, content] : nb::borrow<nb::dict>(object)) {
      const auto name = nb::cast<std::string>(nb::str(key));
      const Part* part = partOf(type, name);
      const Place inside{&place, name};
      if (!part) fail(inside, noSuchField(type, name));
      setFromPython(content, value.part(*part), inside);
    }
    return;
  }
  const PythonClass& known = classOf(type);
  if (!object.type().is(known.type) && PyObject_IsInstance(object.ptr(), known.type.ptr()) != 1) {
    PyErr_Clear();
    unexpected(place, "a " + std::string{type.name}, object);
  }
  for (std::size_t i = 0; i < type.parts.size(); ++i) {
    const Place inside{&place, type.parts[i].name};
    const nb::object content = nb::steal(PyObject_GetAttr(object.ptr(), known.names[i].ptr()));
    if (!content.is_valid()) {
      PyErr_Clear();
      fail(inside, "is missing");
    }
    setFromPython(content, value.part(type.parts[i]), inside);
  }
}

void listFromPython(nb::handle object, Value value, const Place& place) {
  if (!nb::isinstance<nb::sequence>(object) || nb::isinstance<nb::str>(object))
    unexpected(place, "a list", object);
  const std::size_t count = nb::len(object);
  if (value.type->kind == Kind::list)
    value.type->resize(value.data, count);
  else if (count != value.size())
    fail(place,
         "expected " + std::to_string(value.size()) + " elements, got " + std::to_string(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    setFromPython(object[i], value.element(i), {&place, number});
  }
}

/// The text of a scalar, by way of a value of its type.
std::string scalarFromPythonAsText(nb::handle object, const Type& type, const Place& place) {
  if (type.kind == Kind::text) {
    std::string text;
    setFromPython(object, {&type, &text}, place);
    return quotedWord(text);
  }
  alignas(std::max_align_t) std::byte room[8]{};
  setFromPython(object, {&type, room}, place);
  return scalarText(ConstValue{type, room});
}

void setFromPython(nb::handle object, Value value, const Place& place) {
  const Kind kind = value.type->kind;
  if (kind != Kind::record && kind != Kind::array && kind != Kind::list)
    return scalarFromPython(object, value, place);
  if (kind != Kind::list) {
    if (const auto& dense = denseOf(*value.type))
      return arrayFromPython(object, value, *dense, place);
  } else if (const auto dense = denseListForm(ConstValue{value})) {
    return arrayFromPython(object, value, *dense, place);
  }
  if (kind == Kind::record)
    recordFromPython(object, value, place);
  else
    listFromPython(object, value, place);
}

}  // namespace

void fromPython(nb::handle object, Value value, std::string_view path) {
  setFromPython(object, value, {nullptr, path});
}

std::string configText(nb::handle object, const Type& type, const std::string& path) {
  if (type.kind != Kind::record && type.kind != Kind::array && type.kind != Kind::list)
    return scalarFromPythonAsText(object, type, {nullptr, path});
  const Place place{nullptr, path};
  std::string text;
  const auto add = [&](nb::handle part, const Type& partType, std::string_view name) {
    text += (text.empty() ? "" : " ") + configText(part, partType, Place{&place, name}.text());
  };
  if (type.kind == Kind::record && !denseOf(type)) {
    for (const Part& part : type.parts) {
      const std::string name{part.name};
      if (!nb::hasattr(object, name.c_str()))
        unexpected(place, "a " + std::string{type.name}, object);
      add(object.attr(name.c_str()), part.type(), part.name);
    }
    return text;
  }
  const bool anyLength = type.kind == Kind::list;
  const std::size_t wanted = type.kind == Kind::record ? type.parts.size() : type.count;
  if (!nb::isinstance<nb::sequence>(object) || nb::isinstance<nb::str>(object))
    unexpected(place, "an array", object);
  const std::size_t count = nb::len(object);
  if (!anyLength && count != wanted)
    fail(place, "expected " + std::to_string(wanted) + " elements, got " + std::to_string(count));
  for (std::size_t i = 0; i < count; ++i)
    add(object[i], type.kind == Kind::record ? type.parts[i].type() : type.element(),
        std::to_string(i));
  return text;
}

}  // namespace gt::python
