#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/engine/Activation.h"
#include "xabsl/engine/Linker.h"
#include "xabsl/engine/Program.h"
#include "xabsl/engine/Symbols.h"
#include "xabsl/engine/TeamCooperation.h"
#include "xabsl/engine/TraceRecorder.h"
#include "xabsl/language/Behavior.h"
#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// Executes a behavior (report 3.8.1.1, H.7). Depends only on its inputs and the given time. A
/// cycle neither allocates nor looks anything up by name. An engine belongs to one thread at a
/// time.
class Engine {
 public:
  struct Creation;

  /// Links a behavior with the registered symbols. If linking fails, the result has no engine, and
  /// the diagnostics name what is missing.
  static Creation create(const Behavior& behavior, const Symbols& symbols);

  Engine(Engine&&) = default;
  Engine& operator=(Engine&&) = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  /// Runs one cycle: the options from the root option of the selected agent down, each with at most
  /// one transition. `now` is in ms.
  void execute(std::int64_t now);

  /// Selects the agent from the next cycle on. Returns false if no agent has that name.
  bool selectAgent(std::string_view name);
  const std::string& selectedAgent() const;

  /// Replaces the agent's root option until the next selection: by another option with all that it
  /// calls, or by a single basic behavior (report H.8). Parameters start with 0, false or the first
  /// element. Returns false if no option or basic behavior has that name.
  bool selectRootOption(std::string_view name);
  bool selectBehavior(std::string_view name);
  /// The name of the root that cycles execute: an option or a basic behavior.
  const std::string& root() const;

  /// Sets a parameter of the root. Values are written as NamedValue::text shows them. Returns false
  /// if there is no such parameter, or the value is not of its type.
  bool setParameter(std::string_view name, std::string_view value);

  /// Sets an output or internal symbol at once, until the behavior sets it again. Returns false if
  /// there is no such symbol, or the value is not of its type.
  bool setOutput(std::string_view name, std::string_view value);

  /// Resumes from another engine, after its behavior was edited. Elements with the same name keep
  /// their state: active options whose state still exists, with their times; parameters and values
  /// of output and internal symbols of the same type; the selected agent and root; the cooperation
  /// of the team. Everything else starts as in a new engine. Must be called before the first cycle.
  void resumeFrom(const Engine& other);

  /// Gives access to the cooperation: the host sets priorities and carries messages between the
  /// engines of a team. Without messages an engine acts as if it were alone.
  TeamCooperation& cooperation() { return cooperation_; }
  const TeamCooperation& cooperation() const { return cooperation_; }

  /// Records all later cycles, or none (null). The recorder must outlive these cycles. The first
  /// call compiles the behavior once more, with instructions for the recorder, so that engines
  /// without a recorder have no overhead.
  void record(TraceRecorder* recorder);

  const Model& model() const { return *model_; }

  /// The registered value of each element of an enumeration.
  const std::vector<double>& elementValues(int enumeration) const {
    return bindings_.elements[at(enumeration)];
  }

  /// The options and basic behaviors executed in the last cycle, in their order.
  std::vector<Activation> activations() const;

  /// The present value of a symbol. Empty for functions with parameters and unknown names. If an
  /// output and an input symbol have the same name, the value of the output.
  std::optional<NamedValue> symbol(std::string_view name) const;

  /// An argument for a symbol with parameters, written as NamedValue::text shows it.
  struct Argument {
    std::string_view parameter;
    std::string_view value;
  };
  /// The present value of a symbol with parameters. Parameters not given are 0, false or the first
  /// element. Empty if there is no such symbol, parameter or value.
  std::optional<NamedValue> symbol(std::string_view name,
                                   const std::vector<Argument>& arguments) const;

  /// The problems while running, each reported once: divisions by zero, and options and basic
  /// behaviors executed twice in a cycle.
  std::vector<Diagnostic> warnings() const;

 private:
  /// The state of an option from cycle to cycle.
  struct OptionState {
    int option = -1;
    int state = -1;  ///< the active state, or the last one
    std::int64_t activation = 0;
    std::int64_t stateActivation = 0;
    std::uint64_t cycle = 0;     ///< the last cycle in which it was active
    std::uint64_t previous = 0;  ///< the cycle before the last one in which it was active
  };

  /// An option, or without a state a basic behavior.
  struct Executed {
    int index;
    int state;
    int depth;
    std::int64_t stateActivation;
  };

  struct ParameterPlace {
    Type type;
    int index = 0;  ///< in the memory
  };

  /// The return address in the caller of an option.
  struct Frame {
    const Instruction* next;
    OptionState* caller;
  };

  struct Warning {
    const char* text;
    Location location;
  };

  Engine(const Behavior& behavior, Bindings bindings);
  void prepareMemory();
  double& variable(std::size_t symbol) {
    return memory_[static_cast<std::size_t>(layout_.variables) + symbol];
  }
  double variable(std::size_t symbol) const {
    return memory_[static_cast<std::size_t>(layout_.variables) + symbol];
  }
  double firstValue(Type type) const;

  bool select(Activation::Kind kind, int index);
  const std::vector<Parameter>& rootParameters() const;
  double& rootSlot(std::size_t parameter);
  std::optional<double> read(Type type, std::string_view text) const;
  void resumeFrom(const Engine& other, OptionState& option);
  void take(const Engine& other, Type oldType, double oldValue, Type type, double& value);
  std::map<std::string, ParameterPlace> parameterPlaces() const;

  void runBehavior(int index);
  void run(const Program& program);
  void act(const Instruction& instruction, const OptionState& option, int depth);
  double valueOf(const Instruction& instruction, const OptionState& option);
  void recordEvent(const Instruction& instruction, const OptionState& option, int depth);
  void recordState(const OptionState& option);
  void recordBehavior(int index, int depth);

  bool wasActive(const OptionState& option) const;
  void enter(OptionState& option);
  void enterAnew(OptionState& option);
  void note(const OptionState& option, int depth);
  void keepParameters(const double* first, std::size_t count);
  void change(OptionState& option, int state);
  void notifyOfChanges(std::size_t behavior) const;
  void callBehavior(int index, int depth);
  void set(std::size_t symbol);
  void apply(std::size_t symbol);
  bool actionDone(const OptionState& option) const;
  bool subOptionDone(Span actions) const;
  double divide(const Instruction& instruction);
  double modulo(const Instruction& instruction);
  void warnOnce(char& warned, const char* text, Location location);

  static std::int64_t since(std::int64_t then, std::int64_t now);
  double callInput(std::size_t symbol, const double* arguments) const;
  NamedValue named(const std::string& name, Type type, double number) const;

  std::shared_ptr<const Model> model_;
  Bindings bindings_;
  MemoryLayout layout_;
  std::vector<double> memory_;
  Program program_;
  Program recordedProgram_;  ///< empty until a recorder is set
  std::vector<Frame> frames_;
  std::vector<OptionState> options_;
  std::vector<std::uint64_t> behaviorCycles_;
  std::uint64_t cycle_ = 1;
  std::int64_t now_ = 0;
  std::size_t agent_ = 0;
  Activation::Kind rootKind_ = Activation::Kind::option;
  int root_ = 0;
  TeamCooperation cooperation_;
  TraceRecorder* recorder_ = nullptr;
  bool cooperates_ = false;         ///< whether any state is cooperative
  bool parametersChanged_ = false;  ///< of the basic behavior that is about to be called
  /// in XABSL 2.1: the outputs to set after the graph was executed
  std::vector<char> pending_;

  std::vector<Executed> executed_;
  std::vector<double> executedValues_;
  std::vector<Warning> warnings_;
  std::vector<char> warnedExpressions_;
  std::vector<char> warnedOptions_;
  std::vector<char> warnedBehaviors_;
};

/// The result of creating an engine: the engine if there are no errors, and all messages.
struct Engine::Creation {
  std::optional<Engine> engine;
  std::vector<Diagnostic> diagnostics;
};

}  // namespace xabsl
