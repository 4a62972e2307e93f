#include "Values.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include "Failure.h"
#include "Types.h"
#include "base/Lines.h"
#include "streams/NumberType.h"

namespace gt::python {
namespace {

[[noreturn]] void fail(const std::string& path, std::string what) {
  throw Failure{Error{.field = path, .what = std::move(what)}};
}

std::string typeNameOf(nb::handle object) {
  return nb::cast<std::string>(object.type().attr("__name__"));
}

[[noreturn]] void unexpected(const std::string& path, const std::string& expected,
                             nb::handle object) {
  fail(path, "expected " + expected + ", got " + typeNameOf(object));
}

std::string joined(const std::string& path, std::string_view name) {
  return path.empty() ? std::string{name} : path + "." + std::string{name};
}

// From C++ to Python.

nb::object numberToPython(Number number, const void* data) {
  return withType(number, [&]<typename N>(std::type_identity<N>) -> nb::object {
    N n;
    std::memcpy(&n, data, sizeof n);
    if constexpr (std::is_floating_point_v<N>)
      return nb::float_(static_cast<double>(n));
    else
      return nb::int_(n);
  });
}

nb::dlpack::dtype dlpackType(const Type& scalar) {
  if (scalar.kind == Kind::boolean) return nb::dtype<bool>();
  return withType(scalar.number, []<typename N>(std::type_identity<N>) { return nb::dtype<N>(); });
}

const std::byte* address(ConstValue value) {
  return static_cast<const std::byte*>(value.data());
}

/// Whether a dense value of so many bytes lies in memory as it shall lie in an array.
bool isContiguous(ConstValue value, std::size_t bytes) {
  const Type& type = value.type();
  std::size_t at = 0;
  for (const Part& part : type.parts) {
    if (address(value.part(part)) != address(value) + at) return false;
    at += bytes / type.parts.size();
  }
  if (type.kind != Kind::array && type.kind != Kind::list) return true;
  const std::size_t count = value.size();
  if (count < 2) return count == 0 || isContiguous(value.element(0), bytes);
  const std::size_t each = bytes / count;
  const std::byte* const first = address(value.element(0));
  return address(value.element(1)) == first + each &&
         address(value.element(count - 1)) == first + (count - 1) * each &&
         isContiguous(value.element(0), each);
}

/// The address of the first scalar of a dense value that is not empty.
std::byte* dataOf(Value value) {
  const Kind kind = value.type->kind;
  const bool sequence = kind == Kind::array || kind == Kind::list;
  return sequence ? dataOf(value.element(0)) : static_cast<std::byte*>(value.data);
}

/// Calls visit(scalar, place) for each scalar and its place in an array that begins at `place`,
/// which is moved behind them.
template <typename Visit>
void forEachScalar(Value value, std::byte*& place, Visit&& visit) {
  const Type& type = *value.type;
  for (const Part& part : type.parts) forEachScalar(value.part(part), place, visit);
  if (type.kind == Kind::array || type.kind == Kind::list)
    for (std::size_t i = 0; i < value.size(); ++i) forEachScalar(value.element(i), place, visit);
  else if (type.kind != Kind::record) {
    const std::size_t size = type.kind == Kind::boolean ? 1 : numberSize(type.number);
    visit(static_cast<std::byte*>(value.data), place, size);
    place += size;
  }
}

Value writable(ConstValue value) {
  return {&value.type(), const_cast<void*>(value.data())};
}

nb::object arrayToPython(ConstValue value, const Dense& dense) {
  const std::size_t bytes = dense.bytes();
  auto data = std::make_unique<std::byte[]>(std::max<std::size_t>(bytes, 1));
  if (bytes > 0 && isContiguous(value, bytes)) {
    std::memcpy(data.get(), dataOf(writable(value)), bytes);
  } else {
    std::byte* place = data.get();
    forEachScalar(writable(value), place, [](const std::byte* from, std::byte* to, std::size_t n) {
      std::memcpy(to, from, n);
    });
  }
  std::byte* const array = data.release();
  const nb::capsule owner{array, [](void* p) noexcept { delete[] static_cast<std::byte*>(p); }};
  return nb::ndarray<nb::numpy>(array, dense.shape.size(), dense.shape.data(), owner, nullptr,
                                dlpackType(*dense.scalar))
      .cast();
}

/// The form of an array or list whose elements are scalars or dense; empty if they are not.
std::optional<Dense> denseForm(ConstValue value) {
  const Type& type = value.type();
  if (type.kind != Kind::list) return denseOf(type);
  auto dense = denseElementOf(type);
  if (dense) dense->shape.insert(dense->shape.begin(), value.size());
  return dense;
}

nb::object recordToPython(ConstValue value) {
  const PythonClass& known = classOf(value.type());
  auto* const type = reinterpret_cast<PyTypeObject*>(known.type.ptr());
  const nb::object object = nb::steal(PyBaseObject_Type.tp_new(type, nb::tuple().ptr(), nullptr));
  if (!object.is_valid()) throw nb::python_error();
  const auto& parts = value.type().parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    nb::setattr(object, known.names[i], toPython(value.part(parts[i])));
  return object;
}

nb::object listToPython(ConstValue value) {
  nb::list list;
  for (std::size_t i = 0; i < value.size(); ++i) list.append(toPython(value.element(i)));
  return list;
}

// From Python to C++.

bool isAnyBool(nb::handle object) {
  if (PyBool_Check(object.ptr())) return true;
  if (PyFloat_CheckExact(object.ptr()) || PyLong_CheckExact(object.ptr())) return false;
  return typeNameOf(object) == "bool_" || typeNameOf(object) == "bool";
}

template <typename N>
void storeNumber(nb::handle object, void* data, const std::string& path) {
  N n{};
  if constexpr (std::is_floating_point_v<N>) {
    const double number = PyFloat_AsDouble(object.ptr());
    if (PyErr_Occurred()) {
      PyErr_Clear();
      unexpected(path, "a number", object);
    }
    if (!std::isfinite(number)) fail(path, "expected a finite number");
    n = static_cast<N>(number);
  } else {
    const nb::object whole = nb::steal(PyNumber_Index(object.ptr()));
    if (!whole.is_valid()) {
      PyErr_Clear();
      unexpected(path, "a whole number", object);
    }
    if (!nb::try_cast<N>(whole, n))
      fail(path, "is out of the range of its type: " + nb::cast<std::string>(nb::str(whole)));
  }
  std::memcpy(data, &n, sizeof n);
}

void scalarFromPython(nb::handle object, Value value, const std::string& path) {
  const Type& type = *value.type;
  if (type.kind == Kind::boolean) {
    if (!isAnyBool(object)) unexpected(path, "a bool", object);
    setOrdinal(value, PyObject_IsTrue(object.ptr()));
  } else if (type.kind == Kind::number) {
    if (isAnyBool(object)) unexpected(path, "a number", object);
    withType(type.number,
             [&]<typename N>(std::type_identity<N>) { storeNumber<N>(object, value.data, path); });
  } else if (type.kind == Kind::text) {
    if (!nb::isinstance<nb::str>(object)) unexpected(path, "a str", object);
    if (const auto done = setScalar(value, nb::cast<std::string>(object)); !done)
      fail(path, done.error().what);
  } else if (nb::isinstance<nb::str>(object)) {
    if (const auto done = setScalar(value, nb::cast<std::string>(object)); !done)
      fail(path, done.error().what);
  } else {
    const PythonClass& known = classOf(type);
    const bool member = PyObject_IsInstance(object.ptr(), known.type.ptr()) == 1;
    if (!member) unexpected(path, "a " + std::string{type.name} + " or its name", object);
    setOrdinal(value, nb::cast<std::int64_t>(nb::int_(object)));
  }
}

using Array = nb::ndarray<nb::numpy, nb::ro, nb::c_contig, nb::device::cpu>;

/// A Python object as an array of a type and shape, in which -1 is any length.
Array arrayOf(nb::handle object, const Dense& dense, bool anyLength, const std::string& path) {
  nb::list shape;
  for (std::size_t i = 0; i < dense.shape.size(); ++i)
    shape.append(anyLength && i == 0 ? nb::object{nb::none()}
                                     : nb::object{nb::int_(dense.shape[i])});
  try {
    const nb::object as = nb::module_::import_("gt2003._arrays").attr("as_array");
    return nb::cast<Array>(as(object, dense.dtype(), nb::tuple(shape)));
  } catch (nb::python_error& error) {
    if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)) throw;
    fail(path, nb::cast<std::string>(nb::str(error.value())));
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

void arrayFromPython(nb::handle object, Value value, const Dense& dense, const std::string& path) {
  if (copyDoubles(object, value, dense)) return;
  const bool list = value.type->kind == Kind::list;
  const Array array = arrayOf(object, dense, list, path);
  if (list) value.type->resize(value.data, array.shape(0));
  // Only read: what visits it copies from there.
  auto* place = const_cast<std::byte*>(static_cast<const std::byte*>(array.data()));
  const auto names = static_cast<std::int64_t>(dense.scalar->names.size());
  if (dense.scalar->kind == Kind::enumeration) {
    const std::byte* at = place;
    for (std::size_t i = 0; i < array.size(); ++i, at += numberSize(dense.scalar->number)) {
      const std::int64_t number = ordinal(ConstValue{*dense.scalar, at});
      if (number < 0 || number >= names)
        fail(path, "has a value that is no " + std::string{dense.scalar->name} + ": " +
                       std::to_string(number));
    }
  }
  forEachScalar(value, place, [](std::byte* to, const std::byte* from, std::size_t n) {
    std::memcpy(to, from, n);
  });
}

const Part* partOf(const Type& record, std::string_view name) {
  const auto found = std::ranges::find(record.parts, name, &Part::name);
  return found == record.parts.end() ? nullptr : &*found;
}

void recordFromPython(nb::handle object, Value value, const std::string& path) {
  const Type& type = *value.type;
  if (nb::isinstance<nb::dict>(object)) {
    for (const auto& [key, content] : nb::borrow<nb::dict>(object)) {
      const auto name = nb::cast<std::string>(nb::str(key));
      const Part* part = partOf(type, name);
      if (!part) fail(joined(path, name), std::string{type.name} + " has no such field");
      fromPython(content, value.part(*part), joined(path, name));
    }
    return;
  }
  const PythonClass& known = classOf(type);
  if (PyObject_IsInstance(object.ptr(), known.type.ptr()) != 1)
    unexpected(path, "a " + std::string{type.name}, object);
  for (std::size_t i = 0; i < type.parts.size(); ++i) {
    const std::string name = joined(path, type.parts[i].name);
    if (!nb::hasattr(object, known.names[i])) fail(name, "is missing");
    fromPython(object.attr(known.names[i]), value.part(type.parts[i]), name);
  }
}

void listFromPython(nb::handle object, Value value, const std::string& path) {
  if (!nb::isinstance<nb::sequence>(object) || nb::isinstance<nb::str>(object))
    unexpected(path, "a list", object);
  const std::size_t count = nb::len(object);
  if (value.type->kind == Kind::list)
    value.type->resize(value.data, count);
  else if (count != value.size())
    fail(path,
         "expected " + std::to_string(value.size()) + " elements, got " + std::to_string(count));
  for (std::size_t i = 0; i < count; ++i)
    fromPython(object[i], value.element(i), joined(path, std::to_string(i)));
}

/// The text of a scalar, by way of a value of its type.
std::string scalarFromPythonAsText(nb::handle object, const Type& type, const std::string& path) {
  if (type.kind == Kind::text) {
    std::string text;
    fromPython(object, {&type, &text}, path);
    return quotedWord(text);
  }
  alignas(std::max_align_t) std::byte room[8]{};
  fromPython(object, {&type, room}, path);
  return scalarText(ConstValue{type, room});
}

/// An element of a sequence by its name or number; none if it has none.
std::optional<std::size_t> indexOf(const Type& sequence, std::size_t size, std::string_view name) {
  const auto named = std::ranges::find(sequence.indexNames, name);
  if (named != sequence.indexNames.end())
    return static_cast<std::size_t>(named - sequence.indexNames.begin());
  std::size_t index = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (failure != std::errc{} || end != name.data() + name.size() || index >= size)
    return std::nullopt;
  return index;
}

}  // namespace

nb::object toPython(ConstValue value) {
  const Type& type = value.type();
  switch (type.kind) {
    case Kind::boolean:
      return nb::bool_(ordinal(value) != 0);
    case Kind::number:
      return numberToPython(type.number, value.data());
    case Kind::enumeration:
      return classOf(type).type(ordinal(value));
    case Kind::text:
      return nb::cast(*static_cast<const std::string*>(value.data()));
    default:
      break;
  }
  if (const auto dense = denseForm(value)) return arrayToPython(value, *dense);
  return type.kind == Kind::record ? recordToPython(value) : listToPython(value);
}

void fromPython(nb::handle object, Value value, const std::string& path) {
  if (value.type->kind != Kind::record && value.type->kind != Kind::array &&
      value.type->kind != Kind::list)
    scalarFromPython(object, value, path);
  else if (const auto dense = denseForm(ConstValue{value}))
    arrayFromPython(object, value, *dense, path);
  else if (value.type->kind == Kind::record)
    recordFromPython(object, value, path);
  else
    listFromPython(object, value, path);
}

std::string configText(nb::handle object, const Type& type, const std::string& path) {
  if (type.kind != Kind::record && type.kind != Kind::array && type.kind != Kind::list)
    return scalarFromPythonAsText(object, type, path);
  std::string text;
  const auto add = [&](nb::handle part, const Type& partType, std::string_view name) {
    text += (text.empty() ? "" : " ") + configText(part, partType, joined(path, name));
  };
  if (type.kind == Kind::record && !denseOf(type)) {
    for (const Part& part : type.parts) {
      const std::string name{part.name};
      if (!nb::hasattr(object, name.c_str()))
        unexpected(path, "a " + std::string{type.name}, object);
      add(object.attr(name.c_str()), part.type(), part.name);
    }
    return text;
  }
  const bool anyLength = type.kind == Kind::list;
  const std::size_t wanted = type.kind == Kind::record ? type.parts.size() : type.count;
  if (!nb::isinstance<nb::sequence>(object) || nb::isinstance<nb::str>(object))
    unexpected(path, "an array", object);
  const std::size_t count = nb::len(object);
  if (!anyLength && count != wanted)
    fail(path, "expected " + std::to_string(wanted) + " elements, got " + std::to_string(count));
  for (std::size_t i = 0; i < count; ++i)
    add(object[i], type.kind == Kind::record ? type.parts[i].type() : type.element(),
        std::to_string(i));
  return text;
}

ConstValue at(ConstValue root, std::string_view path, const std::string& whole) {
  while (!path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string_view name = path.substr(0, dot);
    path.remove_prefix(std::min(dot + 1, path.size()));
    const Type& type = root.type();
    if (type.kind == Kind::record) {
      const Part* part = partOf(type, name);
      if (!part) fail(whole, std::string{type.name} + " has no field " + std::string{name});
      root = root.part(*part);
    } else if (type.kind == Kind::array || type.kind == Kind::list) {
      const auto index = indexOf(type, root.size(), name);
      if (!index) fail(whole, "there is no element " + std::string{name});
      root = root.element(*index);
    } else {
      fail(whole, "a single value has no field " + std::string{name});
    }
  }
  return root;
}

std::pair<std::string, std::string> splitPath(const std::string& path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  return {path.substr(0, dot), path.substr(std::min(dot + 1, path.size()))};
}

}  // namespace gt::python
