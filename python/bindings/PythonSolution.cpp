#include "PythonSolution.h"

#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "Failure.h"
#include "Types.h"
#include "Values.h"

namespace gt::python {
namespace {

using Inputs = std::vector<std::tuple<std::string, std::string, bool>>;

}  // namespace

void SolutionFailures::note(Failure failure) {
  const std::lock_guard lock{mutex_};
  failures_.push_back(std::move(failure));
}

std::vector<SolutionFailures::Failure> SolutionFailures::all() const {
  const std::lock_guard lock{mutex_};
  auto sorted = failures_;
  std::ranges::stable_sort(sorted, {}, [](const Failure& failure) {
    return std::pair{failure.time, failure.robot};
  });
  return sorted;
}

/// What Python has of it. Released with the interpreter's lock.
struct PythonSolution::Content {
  std::string task, name, instead;
  std::size_t robot = 0;
  std::shared_ptr<SolutionFailures> failures;
  nb::object update, names;    ///< The bound method, and the names of its arguments.
  std::vector<Port> ports;     ///< The inputs in their order, then the outputs in the task's.
  std::vector<bool> isRandom;  ///< For each argument, whether it is a generator, which has no port.
  nb::object generator;        ///< Once a module was made.
  std::vector<KeptObject> inputs;  ///< What `update` got last, in the order of the ports.

  Content() = default;
  Content(const Content&) = delete;
  Content& operator=(const Content&) = delete;
  ~Content() {
    if (!nb::is_alive()) {
      for (nb::object* object : {&update, &names, &generator}) object->release();
      for (KeptObject& input : inputs) input.abandon();
      return;
    }
    const nb::gil_scoped_acquire lock;
    clear();
  }
  void clear() {
    for (nb::object* object : {&update, &names, &generator}) object->reset();
    inputs.clear();
  }
};

/// Calls `update` with the inputs as objects of Python, which are as good as copies.
class PythonSolution::Module : public AnyModule {
 public:
  Module(std::shared_ptr<Content> content, ModuleContext context)
      : content_{std::move(content)}, debug_{&context.debug} {
    for (const Port& port : content_->ports) {
      if (port.kind == PortKind::output)
        outputs_.push_back({port.type, context.blackboard.own(*port.type), port.type->make()});
      else
        inputs_.push_back(&context.blackboard.slot(*port.type));
    }
    const nb::gil_scoped_acquire lock;
    if (!content_->generator.is_valid())
      content_->generator =
          nb::module_::import_("numpy.random").attr("default_rng")(context.random());
  }

  void run() override {
    std::string trace;
    {
      const nb::gil_scoped_acquire lock;
      try {
        return call();
      } catch (const nb::python_error& error) {
        if (error.matches(PyExc_KeyboardInterrupt)) return PyErr_SetInterrupt();  // ends the run
        trace = error.what();
      } catch (const std::exception& error) {
        trace = "what `update` returned: " + std::string{error.what()};
      }
    }
    content_->failures->note(
        {content_->robot, debug_->now(), content_->task, content_->name, trace});
    throw ModuleFailure{trace, content_->instead};
  }

  Findings configure(std::string_view, std::string_view file) override {
    Findings findings;
    findings.add(Error{.file = std::string{file}, .what = noParameters});
    return findings;
  }
  Result<void> set(std::string_view path, std::string_view) override {
    return Error{.field = std::string{path}, .what = noParameters};
  }
  Result<std::string> get(std::string_view path) override {
    return Error{.field = std::string{path}, .what = noParameters};
  }
  std::vector<PathInfo> parameters() override { return {}; }
  bool adopt(AnyModule& other) override {
    const auto* same = dynamic_cast<Module*>(&other);
    return same && same->content_ == content_;
  }

 private:
  static constexpr const char* noParameters = "a solution written in Python has no parameters";

  struct Output {
    const RepresentationType* type;
    void* provided;
    std::shared_ptr<void> returned;
  };

  void call() {
    if (!content_->update.is_valid())
      throw Failure{Error{.field = content_->name, .what = "its match is being destroyed"}};
    content_->inputs.resize(inputs_.size());
    arguments_.clear();
    std::size_t next = 0;
    for (const bool isRandom : content_->isRandom) {
      if (isRandom) {
        arguments_.push_back(content_->generator.ptr());
        continue;
      }
      const Blackboard::Slot& input = *inputs_[next];
      const ConstValue value{*input.type->type(), input.value.get()};
      arguments_.push_back(content_->inputs[next++].set(value).ptr());
    }
    const nb::object result = nb::steal(
        PyObject_Vectorcall(content_->update.ptr(), arguments_.data(), 0, content_->names.ptr()));
    if (!result.is_valid()) nb::raise_python_error();
    if (outputs_.size() == 1) {
      read(result, outputs_.front());
    } else {
      if (!nb::isinstance<nb::tuple>(result) || nb::len(result) != outputs_.size())
        throw Failure{Error{.field = content_->task,
                            .what = "expected a tuple of " + std::to_string(outputs_.size())}};
      for (std::size_t i = 0; i < outputs_.size(); ++i) read(result[i], outputs_[i]);
    }
    for (const Output& output : outputs_) output.type->swap(output.returned.get(), output.provided);
  }

  static void read(nb::handle object, const Output& output) {
    output.type->copy(output.provided, output.returned.get());
    fromPython(object, {output.type->type(), output.returned.get()}, output.type->name);
    if (const auto valid = checked(ConstValue{*output.type->type(), output.returned.get()}); !valid)
      throw Failure{Error{.field = std::string{output.type->name} + "." + valid.error().field,
                          .what = valid.error().what}};
  }

  std::shared_ptr<Content> content_;
  Debug* debug_;
  std::vector<const Blackboard::Slot*> inputs_;
  std::vector<Output> outputs_;
  std::vector<PyObject*> arguments_;  ///< Of the call that runs.
};

PythonSolution::PythonSolution(const Task& task, const nb::object& object, std::size_t robot,
                               std::string instead, std::shared_ptr<SolutionFailures> failures)
    : content_{std::make_shared<Content>()} {
  std::vector<std::string> outputs;
  for (const RepresentationType* output : task.outputs) outputs.emplace_back(output->name);
  const nb::object described =
      nb::module_::import_("gt2003._solution").attr("describe")(object, task.name, outputs);
  content_->task = task.name;
  content_->instead = std::move(instead);
  content_->robot = robot;
  content_->failures = std::move(failures);
  content_->name = nb::cast<std::string>(described[0]);
  content_->update = described[1];
  nb::list names;
  for (const auto& [name, representation, previous] : nb::cast<Inputs>(described[2])) {
    names.append(name);
    content_->isRandom.push_back(representation.empty());
    if (!representation.empty())
      content_->ports.push_back({previous ? PortKind::previous : PortKind::input,
                                 knownRepresentations().at(representation)});
  }
  content_->names = nb::tuple(names);
  for (const RepresentationType* output : task.outputs)
    content_->ports.push_back({PortKind::output, output});
}

const std::string& PythonSolution::name() const {
  return content_->name;
}

const std::string& PythonSolution::instead() const {
  return content_->instead;
}

int PythonSolution::traverse(visitproc visit, void* arg) const {
  for (const nb::object* object : {&content_->update, &content_->names, &content_->generator})
    Py_VISIT(object->ptr());
  for (const KeptObject& input : content_->inputs)
    if (const int done = input.traverse(visit, arg); done != 0) return done;
  return 0;
}

void PythonSolution::clear() {
  content_->clear();
}

Solution PythonSolution::entry() const {
  return {content_->name, content_->ports, [content = content_](ModuleContext context) {
            return std::make_unique<Module>(content, std::move(context));
          }};
}

}  // namespace gt::python
