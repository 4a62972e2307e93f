#include "Values.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>

#include "ValueParts.h"

namespace gt::python {
namespace {

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

}  // namespace

std::optional<Dense> denseListForm(ConstValue value) {
  if (value.type().kind != Kind::list) return std::nullopt;
  auto dense = denseElementOf(value.type());
  if (dense) dense->shape.insert(dense->shape.begin(), value.size());
  return dense;
}

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

}  // namespace gt::python
