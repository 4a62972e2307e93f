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
#include "base/Suggestion.h"
#include "streams/NumberType.h"
#include "streams/Schema.h"

namespace gt::python {
namespace {

/// Where a value stands, as the text of a path only once it is needed.
struct Place {
  const Place* record;  ///< That it is a part of; null: none.
  std::string_view name;

  std::string text() const {
    const std::string before = record ? record->text() : "";
    return before.empty() ? std::string{name} : before + "." + std::string{name};
  }
};

[[noreturn]] void fail(const Place& place, std::string what) {
  throw Failure{Error{.field = place.text(), .what = std::move(what)}};
}

std::string typeNameOf(nb::handle object) {
  return nb::cast<std::string>(object.type().attr("__name__"));
}

[[noreturn]] void unexpected(const Place& place, const std::string& expected, nb::handle object) {
  fail(place, "expected " + expected + ", got " + typeNameOf(object));
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

void copyDense(ConstValue value, std::byte* into, std::size_t bytes) {
  if (bytes > 0 && isContiguous(value, bytes)) {
    std::memcpy(into, dataOf(writable(value)), bytes);
  } else {
    forEachScalar(writable(value), into, [](const std::byte* from, std::byte* to, std::size_t n) {
      std::memcpy(to, from, n);
    });
  }
}

nb::object arrayToPython(ConstValue value, const Dense& dense) {
  const std::size_t bytes = dense.bytes();
  auto data = std::make_unique<std::byte[]>(std::max<std::size_t>(bytes, 1));
  copyDense(value, data.get(), bytes);
  std::byte* const array = data.release();
  const nb::capsule owner{array, [](void* p) noexcept { delete[] static_cast<std::byte*>(p); }};
  return nb::ndarray<nb::numpy>(array, dense.shape.size(), dense.shape.data(), owner, nullptr,
                                dlpackType(*dense.scalar))
      .cast();
}

/// The form of a list whose elements are scalars or dense; empty if they are not.
std::optional<Dense> denseListForm(ConstValue value) {
  if (value.type().kind != Kind::list) return std::nullopt;
  auto dense = denseElementOf(value.type());
  if (dense) dense->shape.insert(dense->shape.begin(), value.size());
  return dense;
}

nb::object newRecord(const PythonClass& known) {
  auto* const type = reinterpret_cast<PyTypeObject*>(known.type.ptr());
  nb::object object = nb::steal(PyBaseObject_Type.tp_new(type, nb::tuple().ptr(), nullptr));
  if (!object.is_valid()) throw nb::python_error();
  return object;
}

nb::object recordToPython(ConstValue value) {
  const PythonClass& known = classOf(value.type());
  const nb::object object = newRecord(known);
  const auto& parts = value.type().parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    nb::setattr(object, known.names[i], toPython(value.part(parts[i])));
  return object;
}

/// Where the numbers of an array lie, if it is still as `arrayToPython` has made it for this form;
/// otherwise null.
std::byte* numbersOf(nb::handle array, const Dense& dense) {
  constexpr std::string_view formats = "bBhHiIlLfd";  // in the order of Number
  const char format = dense.scalar->kind == Kind::boolean
                          ? '?'
                          : formats[static_cast<std::size_t>(dense.scalar->number)];
  Py_buffer view;
  if (PyObject_GetBuffer(array.ptr(), &view, PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE | PyBUF_FORMAT)) {
    PyErr_Clear();
    return nullptr;
  }
  const bool fits =
      view.format && std::string_view{view.format} == std::string_view{&format, 1} &&
      std::equal(dense.shape.begin(), dense.shape.end(), view.shape, view.shape + view.ndim,
                 [](std::size_t n, Py_ssize_t m) { return std::cmp_equal(n, m); });
  PyBuffer_Release(&view);
  return fits ? static_cast<std::byte*>(view.buf) : nullptr;
}

nb::object enumerationToPython(ConstValue value) {
  const PythonClass& known = classOf(value.type());
  const auto number = static_cast<std::size_t>(ordinal(value));
  return number < known.members.size() ? nb::borrow(known.members[number])
                                       : nb::object{known.type(ordinal(value))};
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

/// A field by its name, or by that which it has in logs (`last_seen` for lastSeen).
const Part* partOf(const Type& record, std::string_view name) {
  auto found = std::ranges::find(record.parts, name, &Part::name);
  if (found == record.parts.end())
    found = std::ranges::find_if(record.parts,
                                 [&](const Part& part) { return snakeCase(part.name) == name; });
  return found == record.parts.end() ? nullptr : &*found;
}

std::string noSuchField(const Type& record, std::string_view name) {
  return std::string{record.name} + " has no field " + std::string{name} +
         suggestion(name, namesIn(record.parts));
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

/// An element of a sequence by its name or number; none if it has none.
std::optional<std::size_t> elementIndex(const Type& sequence, std::size_t size,
                                        std::string_view name) {
  const auto named = std::ranges::find(sequence.indexNames, name);
  if (named != sequence.indexNames.end())
    return static_cast<std::size_t>(named - sequence.indexNames.begin());
  std::size_t index = 0;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (failure != std::errc{} || end != name.data() + name.size() || index >= size)
    return std::nullopt;
  return index;
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

nb::object toPython(ConstValue value) {
  const Type& type = value.type();
  switch (type.kind) {
    case Kind::boolean:
      return nb::bool_(ordinal(value) != 0);
    case Kind::number:
      return numberToPython(type.number, value.data());
    case Kind::enumeration:
      return enumerationToPython(value);
    case Kind::text:
      return nb::cast(*static_cast<const std::string*>(value.data()));
    default:
      break;
  }
  if (const auto& dense = denseOf(type)) return arrayToPython(value, *dense);
  if (const auto dense = denseListForm(value)) return arrayToPython(value, *dense);
  return type.kind == Kind::record ? recordToPython(value) : listToPython(value);
}

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

ConstValue at(ConstValue root, std::string_view path, const std::string& whole,
              std::string* spelled) {
  while (!path.empty()) {
    const std::size_t dot = std::min(path.find('.'), path.size());
    const std::string_view name = path.substr(0, dot);
    path.remove_prefix(std::min(dot + 1, path.size()));
    const Type& type = root.type();
    if (type.kind == Kind::record) {
      const Part* part = partOf(type, name);
      if (!part) fail({nullptr, whole}, noSuchField(type, name));
      root = root.part(*part);
      if (spelled) spelled->append(".").append(part->name);
      continue;
    } else if (type.kind == Kind::array || type.kind == Kind::list) {
      const auto index = elementIndex(type, root.size(), name);
      if (!index) fail({nullptr, whole}, "there is no element " + std::string{name});
      root = root.element(*index);
    } else {
      fail({nullptr, whole}, "a single value has no field " + std::string{name});
    }
    if (spelled) spelled->append(".").append(name);
  }
  return root;
}

const nb::object& KeptObject::set(ConstValue value, Py_ssize_t owners) {
  const Type& type = value.type();
  const bool own = object_.is_valid() && Py_REFCNT(object_.ptr()) == owners;
  if (const auto& dense = denseOf(type)) {
    if (own && numbers_ && numbersOf(object_, *dense) == numbers_) {
      copyDense(value, numbers_, dense->bytes());
    } else {
      object_ = arrayToPython(value, *dense);
      numbers_ = numbersOf(object_, *dense);
    }
  } else if (type.kind == Kind::record) {
    const PythonClass& known = classOf(type);
    if (!own || !object_.type().is(known.type)) object_ = newRecord(known);
    parts_.resize(type.parts.size());
    for (std::size_t i = 0; i < type.parts.size(); ++i)
      parts_[i].setPart(object_, known.names[i], value.part(type.parts[i]));
  } else {
    object_ = toPython(value);
  }
  return object_;
}

void KeptObject::setPart(nb::handle record, nb::handle name, ConstValue value) {
  const Kind kind = value.type().kind;
  if (kind != Kind::record && kind != Kind::array)
    return nb::setattr(record, name, toPython(value));
  const void* const before = object_.ptr();
  nb::object known = nb::steal(PyObject_GetAttr(record.ptr(), name.ptr()));
  if (!known.is_valid()) PyErr_Clear();  // of a new record, or somebody has deleted it
  const bool inRecord = known.is_valid() && known.ptr() == before;
  known.reset();
  set(value, inRecord ? 2 : 1);
  if (!inRecord || object_.ptr() != before) nb::setattr(record, name, object_);
}

int KeptObject::traverse(visitproc visit, void* arg) const {
  Py_VISIT(object_.ptr());
  for (const KeptObject& part : parts_)
    if (const int done = part.traverse(visit, arg); done != 0) return done;
  return 0;
}

void KeptObject::clear() {
  parts_.clear();
  object_.reset();
}

void KeptObject::abandon() {
  for (KeptObject& part : parts_) part.abandon();
  object_.release();
}

std::pair<std::string, std::string> splitPath(const std::string& path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  return {path.substr(0, dot), path.substr(std::min(dot + 1, path.size()))};
}

}  // namespace gt::python
