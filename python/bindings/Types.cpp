#include "Types.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include "Values.h"
#include "framework/RepresentationDefinition.h"
#include "logs/RobotLog.h"
#include "match/MatchSummary.h"
#include "robot/Solutions.h"

namespace gt::python {
namespace {

bool isScalar(const Type& type) {
  return type.kind == Kind::boolean || type.kind == Kind::number || type.kind == Kind::enumeration;
}

bool consistsOfNumbers(const Type& record) {
  const Type& first = record.parts.front().type();
  return std::ranges::all_of(record.parts, [&](const Part& part) {
    return part.type().kind == Kind::number && part.type().number == first.number;
  });
}

std::string dtypeOf(const Type& scalar) {
  return scalar.kind == Kind::boolean ? "bool" : numberName(scalar.number);
}

/// Whether a record is an array in Python: a vector, or bytes such as those of a pixel.
bool isVector(const Type& type) {
  return type.kind == Kind::record && !type.parts.empty() && consistsOfNumbers(type) &&
         (type.basic || type.parts.front().type().number == Number::uint8);
}

class TypeCollector {
 public:
  void add(const Type& type) {
    if (std::ranges::find(seen_, &type) != seen_.end()) return;
    seen_.push_back(&type);
    for (const Part& part : type.parts) add(part.type());
    if (type.element) add(type.element());
    types.push_back(&type);
  }

  std::vector<const Type*> types;

 private:
  std::vector<const Type*> seen_;
};

/// The types of the parameters of a solution, of which a module is made for that.
void addParameters(const Solution& solution, TypeCollector& types) {
  Blackboard blackboard;
  Debug debug{1};
  for (const PathInfo& parameter : solution.make({blackboard, debug, Random{}})->parameters())
    types.add(*parameter.value.type);
}

/// All types that exist in Python, each behind those it consists of.
const std::vector<const Type*>& knownTypes() {
  static const std::vector<const Type*> all = [] {
    TypeCollector collector;
    for (const auto& [name, type] : knownRepresentations()) collector.add(*type->type());
    for (const auto& [name, task] : allModules().solutions.tasks())
      for (const Solution& solution : task.solutions) addParameters(solution, collector);
    return collector.types;
  }();
  return all;
}

std::optional<Dense> findDense(const Type& type) {
  if (isVector(type)) return Dense{&type.parts.front().type(), {type.parts.size()}};
  if (type.kind != Kind::array) return std::nullopt;
  auto dense = denseElementOf(type);
  if (dense) dense->shape.insert(dense->shape.begin(), type.count);
  return dense;
}

template <typename Visit>
void forEachRepresentation(Visit visit) {
  for (const RepresentationType* type : allModules().messageTypes()) visit(*type);
  for (const auto& [name, task] : allModules().solutions.tasks())
    for (const Solution& solution : task.solutions)
      for (const Port& port : solution.ports) visit(*port.type);
  visit(representation<MatchSummary>());
  visit(representation<MatchTimes>());
  visit(representation<ImageHeader>());
  visit(representation<SensorData>());
}

std::unordered_map<const Type*, PythonClass>& classes() {
  // Python's objects must not be freed behind Python's end.
  static auto* const all = new std::unordered_map<const Type*, PythonClass>;
  return *all;
}

std::size_t indexOf(const Type& type) {
  const auto& types = knownTypes();
  return static_cast<std::size_t>(std::ranges::find(types, &type) - types.begin());
}

std::string kindName(const Type& type) {
  constexpr std::array names{"boolean", "number", "enumeration", "text", "array", "list", "record"};
  return names[static_cast<std::size_t>(type.kind)];
}

std::vector<std::string> stringsOf(std::span<const std::string_view> names) {
  return {names.begin(), names.end()};
}

nb::dict describePart(const Part& part) {
  nb::dict about;
  about["name"] = std::string{part.name};
  about["type"] = indexOf(part.type());
  about["unit"] = std::string{part.unit};
  about["doc"] = std::string{part.doc};
  about["range"] = part.range.bounds() ? nb::object{nb::make_tuple(part.range.low, part.range.high)}
                                       : nb::object{nb::none()};
  return about;
}

nb::dict describeType(const Type& type) {
  nb::dict about;
  about["name"] = std::string{type.name};
  about["kind"] = kindName(type);
  about["number"] = isScalar(type) ? dtypeOf(type) : "";
  about["vector"] = isVector(type);
  about["names"] = stringsOf(type.names);
  about["index_names"] = stringsOf(type.indexNames);
  about["element"] =
      type.element ? nb::object{nb::int_(indexOf(type.element()))} : nb::object{nb::none()};
  nb::list parts;
  for (const Part& part : type.parts) parts.append(describePart(part));
  about["parts"] = parts;
  auto dense = denseOf(type);
  const bool listed = !dense && type.kind == Kind::list;
  if (listed) dense = denseElementOf(type);
  about["dtype"] = dense ? nb::object{nb::cast(dense->dtype())} : nb::object{nb::none()};
  nb::list shape;
  if (dense && listed) shape.append(nb::none());
  if (dense)
    for (const std::size_t length : dense->shape) shape.append(length);
  about["shape"] = nb::tuple(shape);
  return about;
}

/// For each type what the package makes its class of.
nb::list describeTypes() {
  nb::list all;
  for (const Type* type : knownTypes()) all.append(describeType(*type));
  return all;
}

/// The index of each representation's type, by name.
nb::dict describeRepresentations() {
  nb::dict all;
  for (const auto& [name, type] : knownRepresentations())
    all[name.c_str()] = indexOf(*type->type());
  return all;
}

/// A value of each type: as it is in a new representation, or as a new element of a list in one.
class Defaults {
 public:
  Defaults() {
    for (const bool withElements : {false, true}) {
      std::unordered_set<const Type*> visited;
      for (const auto& [name, type] : knownRepresentations()) {
        made_.push_back(type->make());
        add({type->type(), made_.back().get()}, withElements, visited);
      }
    }
  }

  nb::object of(const Type& type) const {
    const auto found = values_.find(&type);
    if (found == values_.end())
      throw nb::type_error(("there is no default of " + std::string{type.name}).c_str());
    return toPython(found->second);
  }

 private:
  void add(Value value, bool withElements, std::unordered_set<const Type*>& visited) {
    const Type& type = *value.type;
    if (!visited.insert(&type).second) return;
    values_.emplace(&type, value);
    for (const Part& part : type.parts) add(value.part(part), withElements, visited);
    if (withElements && type.kind == Kind::list) type.resize(value.data, 1);
    if (type.element && value.size() > 0) add(value.element(0), withElements, visited);
  }

  std::vector<std::shared_ptr<void>> made_;
  std::unordered_map<const Type*, Value> values_;
};

nb::object defaultOf(std::size_t index) {
  static const Defaults defaults;
  return defaults.of(*knownTypes().at(index));
}

void adopt(std::size_t index, nb::type_object type) {
  const Type& known = *knownTypes().at(index);
  PythonClass& made = classes()[&known];
  for (std::size_t i = 0; i < known.names.size(); ++i) made.members.push_back(type(i).release());
  made.type = type.release();
  for (const Part& part : known.parts) {
    PyObject* name =
        PyUnicode_FromStringAndSize(part.name.data(), static_cast<Py_ssize_t>(part.name.size()));
    PyUnicode_InternInPlace(&name);
    made.names.emplace_back(name);
  }
}

}  // namespace

std::size_t Dense::bytes() const {
  std::size_t product = scalar->kind == Kind::boolean ? 1 : numberSize(scalar->number);
  for (const std::size_t length : shape) product *= length;
  return product;
}

std::string Dense::dtype() const {
  return dtypeOf(*scalar);
}

const std::optional<Dense>& denseOf(const Type& type) {
  static std::unordered_map<const Type*, std::optional<Dense>> known;
  const auto found = known.find(&type);
  return found != known.end() ? found->second : known.emplace(&type, findDense(type)).first->second;
}

std::optional<Dense> denseElementOf(const Type& sequence) {
  const Type& element = sequence.element();
  return isScalar(element) ? Dense{&element, {}} : denseOf(element);
}

std::string numberName(Number number) {
  constexpr std::array names{"int8",   "uint8", "int16",  "uint16",  "int32",
                             "uint32", "int64", "uint64", "float32", "float64"};
  return names[static_cast<std::size_t>(number)];
}

const std::map<std::string, const RepresentationType*>& knownRepresentations() {
  static const auto all = [] {
    std::map<std::string, const RepresentationType*> known;
    forEachRepresentation([&](const RepresentationType& type) {
      if (type.type()) known.emplace(type.name, &type);
    });
    return known;
  }();
  return all;
}

const PythonClass& classOf(const Type& type) {
  const auto known = classes().find(&type);
  if (known == classes().end())
    throw nb::import_error("gt2003.representations is not loaded: import gt2003");
  return known->second;
}

void bindTypes(nb::module_& module) {
  module.def("_types", &describeTypes);
  module.def("_representations", &describeRepresentations);
  module.def("_adopt", &adopt);
  module.def("_default", &defaultOf);
}

}  // namespace gt::python
