#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

#include "Failure.h"
#include "Tools.h"
#include "xabsl/engine/Engine.h"
#include "xabsl/engine/VirtualSymbols.h"
#include "xabsl/formats/Compile.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

nb::list diagnosticsOf(const std::vector<xabsl::Diagnostic>& diagnostics) {
  const nb::object type = nb::module_::import_("gt2003.xabsl").attr("Diagnostic");
  nb::list all;
  for (const xabsl::Diagnostic& d : diagnostics)
    all.append(type(d.severity == xabsl::Diagnostic::Severity::error ? "error" : "warning", d.file,
                    d.line, d.column, d.message, d.source));
  return all;
}

template <typename List>
std::vector<std::string> declaredNames(const List& list) {
  std::vector<std::string> names;
  for (const auto& element : list) names.push_back(element.name);
  return names;
}

std::vector<std::string> symbolsOf(const xabsl::Behavior& behavior, xabsl::SymbolKind kind) {
  std::vector<std::string> names;
  for (const xabsl::Symbol& symbol : behavior.model().symbols)
    if (symbol.kind == kind) names.push_back(symbol.name);
  return names;
}

nb::object symbolValue(const xabsl::Model& model, xabsl::Type type, double number) {
  switch (type.kind) {
    case xabsl::ValueKind::boolean:
      return nb::bool_(number != 0);
    case xabsl::ValueKind::number:
      return nb::float_(number);
    case xabsl::ValueKind::enumeration:
      break;
  }
  const auto& elements = model.enumerations[static_cast<std::size_t>(type.enumeration)].elements;
  const auto index = static_cast<std::size_t>(number);
  return nb::cast(index < elements.size() ? elements[index].name : std::string{});
}

double symbolNumber(const xabsl::Model& model, xabsl::Type type, nb::handle value,
                    const std::string& name) {
  if (type.kind == xabsl::ValueKind::boolean) {
    if (!PyBool_Check(value.ptr())) refuse(name, "expected a bool");
    return value.ptr() == Py_True;
  }
  if (type.kind == xabsl::ValueKind::number) {
    double number = PyBool_Check(value.ptr()) ? NAN : PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred()) {
      PyErr_Clear();
      number = NAN;
    }
    if (!std::isfinite(number)) refuse(name, "expected a finite number");
    return number;
  }
  const auto& enumeration = model.enumerations[static_cast<std::size_t>(type.enumeration)];
  std::string element;
  if (!nb::try_cast(value, element)) refuse(name, "expected a name of " + enumeration.name);
  for (std::size_t i = 0; i < enumeration.elements.size(); ++i)
    if (enumeration.elements[i].name == element) return static_cast<double>(i);
  refuse(name, enumeration.name + " has no element " + element);
}

/// A behavior that runs on symbols of Python.
class PythonEngine {
 public:
  /// `functions` are called for symbols and basic behaviors by name; all others are values.
  PythonEngine(const xabsl::Behavior& behavior, const nb::dict& functions)
      : behavior_{behavior}, virtual_{std::make_unique<xabsl::VirtualSymbols>(behavior.model())} {
    xabsl::Symbols symbols = virtual_->symbols();
    for (const auto& [key, function] : functions) {
      const auto name = nb::cast<std::string>(nb::str(key));
      if (!PyCallable_Check(function.ptr())) refuse(name, "expected something to call");
      add(symbols, name, nb::borrow<nb::object>(function));
    }
    auto creation = xabsl::Engine::create(behavior, symbols);
    if (!creation.engine)
      refuse("behavior", creation.diagnostics.empty() ? "cannot be linked"
                                                      : toString(creation.diagnostics.front()));
    engine_.emplace(std::move(*creation.engine));
  }

  void execute(std::int64_t now) {
    const Use use{*this};
    engine_->execute(now);
    if (!failed_) return;
    auto thrown = std::exchange(failed_, nullptr);
    std::rethrow_exception(thrown);
  }

  void set(const std::string& name, nb::handle value) {
    const Use use{*this};
    const int symbol = model().findInput(name);
    if (symbol < 0) refuse(name, "the behavior has no such input symbol");
    const xabsl::Symbol& described = model().symbols[static_cast<std::size_t>(symbol)];
    virtual_->value(symbol) = symbolNumber(model(), described.type, value, name);
  }
  nb::object get(const std::string& name) {
    const Use use{*this};
    for (const int symbol : {model().findOutput(name), model().findInput(name)})
      if (symbol >= 0) {
        const xabsl::Symbol& described = model().symbols[static_cast<std::size_t>(symbol)];
        if (!described.parameters.empty()) refuse(name, "has parameters");
        const auto value = engine_->symbol(name);
        if (!value) refuse(name, "has no value");
        if (failed_) std::rethrow_exception(std::exchange(failed_, nullptr));
        return symbolValue(model(), described.type, value->number);
      }
    refuse(name, "the behavior has no such symbol");
  }
  void select(const std::string& kind, const std::string& name) {
    const Use use{*this};
    const bool done = kind == "agent"    ? engine_->selectAgent(name)
                      : kind == "option" ? engine_->selectRootOption(name)
                                         : engine_->selectBehavior(name);
    if (!done) refuse(name, "the behavior has no such " + kind);
  }
  const std::string& agent() const { return engine_->selectedAgent(); }

  nb::list activations() {
    const Use use{*this};
    const nb::object type = nb::module_::import_("gt2003.xabsl").attr("Activation");
    nb::list all;
    for (const xabsl::Activation& a : engine_->activations()) {
      nb::dict parameters;
      for (const xabsl::NamedValue& value : a.parameters)
        parameters[value.name.c_str()] = value.text;
      all.append(type(a.kind == xabsl::Activation::Kind::option ? "option" : "behavior", a.depth,
                      a.name, a.state, a.target, a.optionTime, a.stateTime, parameters));
    }
    return all;
  }
  nb::list warnings() const { return diagnosticsOf(engine_->warnings()); }

  // For the garbage collector.
  int traverse(visitproc visit, void* arg) const {
    for (const Called& called : called_) Py_VISIT(called.function.ptr());
    return 0;
  }
  void clear() {
    for (Called& called : called_) called.function.reset();
  }

 private:
  /// What is called for a name; exceptions wait until the cycle is over.
  struct Called {
    PythonEngine* engine;
    nb::object function;
    std::string name;
    xabsl::Type type;  ///< Of the result; of an output's value.
    bool output = false;
    std::vector<xabsl::Parameter> parameters;
  };
  /// Marks the engine as used: what it calls must not use it.
  class Use {
   public:
    explicit Use(PythonEngine& engine) : engine_{engine} {
      if (engine.used_) refuse("engine", "runs already");
      engine_.used_ = true;
    }
    ~Use() { engine_.used_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    PythonEngine& engine_;
  };

  const xabsl::Model& model() const { return behavior_.model(); }

  void add(xabsl::Symbols& symbols, const std::string& name, nb::object function) {
    const auto called = [&](xabsl::RegisteredFunction registered, Called made) {
      registered.function = {&call, std::shared_ptr<void>{std::shared_ptr<void>{},
                                                          &called_.emplace_back(std::move(made))}};
      return registered;
    };
    const auto& all = model().symbols;
    if (const int input = model().findInput(name); input >= 0) {
      const xabsl::Symbol& symbol = all[static_cast<std::size_t>(input)];
      symbols.addInput(
          name, called(*symbols.findInput(name),
                       {this, std::move(function), name, symbol.type, false, symbol.parameters}));
      return;
    }
    if (const auto* registered = symbols.findOutput(name)) {
      const xabsl::Symbol& symbol = all[static_cast<std::size_t>(model().findOutput(name))];
      symbols.addOutput(
          name, called(*registered, {this, std::move(function), name, symbol.type, true, {}}));
      return;
    }
    const auto& behaviors = model().behaviors;
    const auto behavior = std::ranges::find(behaviors, name, &xabsl::BasicBehavior::name);
    if (behavior == behaviors.end())
      refuse(name, "the behavior has no such symbol and no such basic behavior");
    symbols.addBehavior(name,
                        called(*symbols.findBehavior(name),
                               {this, std::move(function), name, {}, false, behavior->parameters}));
  }

  static double call(void* object, const double* arguments) {
    auto& called = *static_cast<Called*>(object);
    PythonEngine& engine = *called.engine;
    if (engine.failed_ || !called.function.is_valid()) return 0;
    try {
      return engine.call(called, arguments);
    } catch (...) {
      engine.failed_ = std::current_exception();
      return 0;
    }
  }

  double call(const Called& called, const double* arguments) const {
    if (called.output) {
      called.function(symbolValue(model(), called.type, *arguments));
      return 0;
    }
    nb::dict given;
    for (std::size_t i = 0; i < called.parameters.size(); ++i)
      given[called.parameters[i].name.c_str()] =
          symbolValue(model(), called.parameters[i].type, arguments[i]);
    const nb::object result = called.function(**given);
    const bool isInput = model().findInput(called.name) >= 0;
    return isInput ? symbolNumber(model(), called.type, result, called.name) : 0;
  }

  xabsl::Behavior behavior_;
  std::unique_ptr<xabsl::VirtualSymbols> virtual_;
  std::deque<Called> called_;
  std::optional<xabsl::Engine> engine_;
  std::exception_ptr failed_;
  bool used_ = false;
};

int traverseEngine(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  return nb::inst_ready(self) ? nb::inst_ptr<PythonEngine>(self)->traverse(visit, arg) : 0;
}

int clearEngine(PyObject* self) {
  if (nb::inst_ready(self)) nb::inst_ptr<PythonEngine>(self)->clear();
  return 0;
}

PyType_Slot engineSlots[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverseEngine)},
                             {Py_tp_clear, reinterpret_cast<void*>(&clearEngine)},
                             {0, nullptr}};

nb::tuple compile(const std::string& path,
                  const std::optional<std::map<std::string, std::string>>& files) {
  auto compiled = files ? xabsl::compile(path, *files) : xabsl::compile(path);
  const nb::object behavior =
      compiled.behavior ? nb::cast(std::move(*compiled.behavior)) : nb::none();
  return nb::make_tuple(behavior, diagnosticsOf(compiled.diagnostics));
}

}  // namespace

void bindXabsl(nb::module_& module) {
  module.def("_compile_xabsl", &compile, "path"_a, "files"_a.none());
  nb::class_<xabsl::Behavior>(module, "Behavior", "A compiled behavior, which never changes.")
      .def_prop_ro("agents",
                   [](const xabsl::Behavior& b) { return declaredNames(b.model().agents); })
      .def_prop_ro("options",
                   [](const xabsl::Behavior& b) { return declaredNames(b.model().options); })
      .def_prop_ro("basic_behaviors",
                   [](const xabsl::Behavior& b) { return declaredNames(b.model().behaviors); })
      .def_prop_ro("inputs",
                   [](const xabsl::Behavior& b) { return symbolsOf(b, xabsl::SymbolKind::input); })
      .def_prop_ro("outputs",
                   [](const xabsl::Behavior& b) { return symbolsOf(b, xabsl::SymbolKind::output); })
      .def_prop_ro("enumerations", [](const xabsl::Behavior& b) {
        nb::dict all;
        for (const xabsl::Enumeration& enumeration : b.model().enumerations)
          all[enumeration.name.c_str()] = declaredNames(enumeration.elements);
        return all;
      });
  nb::class_<PythonEngine>(
      module, "Engine", nb::type_slots(engineSlots),
      "Executes a behavior on symbols of Python.\n\n"
      "Numbers are float, booleans bool, elements of enumerations their names.")
      .def(
          nb::init<const xabsl::Behavior&, const nb::dict&>(), "behavior"_a,
          "functions"_a = nb::dict(),
          nb::sig("def __init__(self, behavior: Behavior, functions: dict[str, "
                  "collections.abc.Callable[..., typing.Any]] = {}) -> None"),
          "functions: what is called for a symbol or a basic behavior. An input symbol's function\n"
          "takes its parameters by name and returns its value; an output symbol's takes the value\n"
          "that is set; a basic behavior's takes its parameters by name. Symbols without a "
          "function\n"
          "are values that `set` sets.")
      .def("execute", &PythonEngine::execute, "now"_a,
           "Runs one cycle at this time (ms). What a function raises is raised at its end; no\n"
           "further function is called then.")
      .def("set", &PythonEngine::set, "name"_a, "value"_a, "Sets an input symbol.",
           nb::sig("def set(self, name: str, value: float | bool | str) -> None"))
      .def("get", &PythonEngine::get, "name"_a, "The present value of a symbol.",
           nb::sig("def get(self, name: str) -> float | bool | str"))
      .def(
          "select_agent",
          [](PythonEngine& self, const std::string& name) { self.select("agent", name); }, "name"_a,
          "Selects the agent whose root option the next cycles execute.")
      .def(
          "select_option",
          [](PythonEngine& self, const std::string& name) { self.select("option", name); },
          "name"_a, "Has an option executed instead.")
      .def(
          "select_behavior",
          [](PythonEngine& self, const std::string& name) { self.select("basic behavior", name); },
          "name"_a, "Has a basic behavior executed alone.")
      .def_prop_ro("agent", &PythonEngine::agent)
      .def_prop_ro("activations", &PythonEngine::activations,
                   nb::sig("def activations(self) -> list[gt2003.xabsl.Activation]"),
                   "What the last cycle executed, in its order.")
      .def_prop_ro("warnings", &PythonEngine::warnings,
                   nb::sig("def warnings(self) -> list[gt2003.xabsl.Diagnostic]"),
                   "What went wrong while it ran, each problem once.");
}

}  // namespace gt::python
