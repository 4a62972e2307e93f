#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <typeindex>
#include <utility>
#include <vector>

#include "xabsl/engine/Function.h"

namespace xabsl {

/// Names a parameter of a registered function, in the order of its arguments. With the name of an
/// enumeration, an integer argument takes the index of an element.
struct ParameterName {
  ParameterName(const char* parameter) : name(parameter) {}  // NOLINT: written as a plain string
  ParameterName(std::string parameter, std::string enumerationName = {})  // NOLINT: the same
      : name(std::move(parameter)), enumeration(std::move(enumerationName)) {}

  std::string name;
  std::string enumeration;
};

struct RegisteredParameter {
  std::string name;
  RegisteredType type;
};

/// A registered input or output symbol or basic behavior.
struct RegisteredFunction {
  Function function;
  RegisteredType type;  ///< of the symbol
  std::vector<RegisteredParameter> parameters;
  std::function<void(const double* arguments)>
      parametersChanged;  ///< of a basic behavior; may be empty
};

struct RegisteredEnumeration {
  std::vector<std::string> elements;  ///< the value of an element is its index
  std::type_index type = typeid(void);
};

/// Whether T is a pointer to data; everything else that is registered is called.
template <typename T>
constexpr bool isVariable = std::is_pointer_v<T> && !std::is_function_v<std::remove_pointer_t<T>>;

/// The registry of a program for behaviors: variables, functions, enumerations and basic behaviors,
/// by the names used in XABSL (report H.3 to H.5). Types are deduced from C++: bool is bool, an
/// enum class is the enumeration registered for it, any other number is float. Registering a name
/// again replaces the earlier entry. Objects registered by pointer must outlive the engines that
/// use them.
class Symbols {
 public:
  /// Registers the names in XABSL of an enum's values 0, 1, ...
  template <typename Enum>
  void enumeration(const std::string& name, std::vector<std::string> elements) {
    static_assert(std::is_enum_v<Enum>);
    addEnumeration(name, std::move(elements), typeid(Enum));
  }

  /// Registers the names of some of an enum's values, in any order and with gaps.
  template <typename Enum>
  void enumerationValues(const std::string& name,
                         const std::vector<std::pair<Enum, std::string>>& elements) {
    std::vector<std::string> names;
    for (const auto& [value, element] : elements) place(names, static_cast<int>(value), element);
    enumeration<Enum>(name, std::move(names));
  }

  /// Registers an enumeration without a C++ type; its values are indices.
  void enumeration(const std::string& name, std::vector<std::string> elements) {
    addEnumeration(name, std::move(elements), typeid(void));
  }

  /// Registers a variable that is read each time the symbol is used.
  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void input(const std::string& name, const T* variable) {
    input(name, [variable] { return *variable; });
    inputs_[name].function.variable = variableOf(variable);
  }

  /// Registers a function that is called each time the symbol is used. Its arguments are the
  /// parameters of the symbol.
  template <typename Callable>
  requires(!isVariable<Callable>) void input(const std::string& name,
                                             const std::vector<ParameterName>& parameters,
                                             Callable callable) {
    add(inputs_[name], makeFunction(std::move(callable)), registeredType<ResultOf<Callable>>(),
        argumentTypes<Callable>(), parameters);
  }
  template <typename Callable>
  requires(!isVariable<Callable>) void input(const std::string& name, Callable callable) {
    input(name, {}, std::move(callable));
  }

  /// Registers a symbol of an enumeration without a C++ type: the callable returns an index.
  template <typename Callable>
  void inputIndex(const std::string& name, const std::string& enumeration, Callable callable) {
    static_assert(std::is_integral_v<ResultOf<Callable>>);
    input(name, {}, std::move(callable));
    setIndex(inputs_[name], enumeration);
  }

  /// Registers a variable that is written each time the symbol is set.
  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void output(const std::string& name, T* variable) {
    output(name, [variable](T value) { *variable = value; });
  }

  /// Registers a function of one argument that is called each time the symbol is set.
  template <typename Callable>
  requires(!isVariable<Callable>) void output(const std::string& name, Callable callable) {
    static_assert(std::tuple_size_v<ArgumentsOf<Callable>> == 1);
    add(outputs_[name], makeFunction(std::move(callable)), argumentTypes<Callable>().front(), {},
        {});
  }

  /// Registers an output symbol of an enumeration without a C++ type: the callable takes an index.
  template <typename Callable>
  void outputIndex(const std::string& name, const std::string& enumeration, Callable callable) {
    static_assert(std::is_integral_v<std::tuple_element_t<0, ArgumentsOf<Callable>>>);
    output(name, std::move(callable));
    setIndex(outputs_[name], enumeration);
  }

  /// Registers a basic behavior: a callable that is called in each cycle that executes it, with its
  /// parameters as arguments. `parametersChanged` is called before, if an argument has changed
  /// since the last call.
  template <typename Callable>
  void behavior(const std::string& name, const std::vector<ParameterName>& parameters,
                Callable callable, std::function<void()> parametersChanged = {}) {
    RegisteredFunction& entry = behaviors_[name] = {};
    add(entry, makeFunction(std::move(callable)), {}, argumentTypes<Callable>(), parameters);
    if (parametersChanged)
      entry.parametersChanged = [changed = std::move(parametersChanged)](const double*) {
        changed();
      };
  }
  template <typename Callable>
  requires(!std::is_convertible_v<Callable, std::vector<ParameterName>>) void behavior(
      const std::string& name, Callable callable) {
    behavior(name, {}, std::move(callable));
  }

  /// Registers an object of a class as a basic behavior. The object must outlive engines.
  template <BehaviorClass Class>
  void behavior(Class& object) {
    RegisteredFunction& entry = behaviors_[Class::name] = {};
    entry.function.object = std::shared_ptr<void>(std::shared_ptr<void>(), &object);
    entry.function.call = [](void* called, const double* arguments) {
      takeParameters(*static_cast<Class*>(called), arguments);
      static_cast<Class*>(called)->execute();
      return 0.0;
    };
    std::apply(
        [&]<typename... T>(const MemberParameter<Class, T>&... parameters) {
          (entry.parameters.push_back({parameters.name, registeredType<T>()}), ...);
        },
        Class::parameters());
    if constexpr (requires { object.parametersChanged(); })
      entry.parametersChanged = [&object](const double* arguments) {
        takeParameters(object, arguments);
        object.parametersChanged();
      };
  }

  /// Register functions for tools that have no C++ types.
  void addInput(const std::string& name, RegisteredFunction function) {
    inputs_[name] = std::move(function);
  }
  void addOutput(const std::string& name, RegisteredFunction function) {
    outputs_[name] = std::move(function);
  }
  void addBehavior(const std::string& name, RegisteredFunction function) {
    behaviors_[name] = std::move(function);
  }

  /// The entry registered under a name, or null.
  const RegisteredFunction* findInput(const std::string& name) const { return find(inputs_, name); }
  const RegisteredFunction* findOutput(const std::string& name) const {
    return find(outputs_, name);
  }
  const RegisteredFunction* findBehavior(const std::string& name) const {
    return find(behaviors_, name);
  }
  const RegisteredEnumeration* findEnumeration(const std::string& name) const {
    return find(enumerations_, name);
  }

  /// The name under which a C++ enum was registered; empty if it was not.
  std::string enumerationName(const RegisteredType& type) const;

  /// All registered entries, by name.
  const std::map<std::string, RegisteredFunction>& inputs() const { return inputs_; }
  const std::map<std::string, RegisteredFunction>& outputs() const { return outputs_; }
  const std::map<std::string, RegisteredFunction>& behaviors() const { return behaviors_; }

 private:
  template <typename T>
  static const T* find(const std::map<std::string, T>& table, const std::string& name) {
    const auto found = table.find(name);
    return found == table.end() ? nullptr : &found->second;
  }

  static void place(std::vector<std::string>& names, int value, const std::string& name);
  void addEnumeration(const std::string& name, std::vector<std::string> elements,
                      std::type_index type);
  static void add(RegisteredFunction& entry, Function function, RegisteredType type,
                  std::vector<RegisteredType> arguments, const std::vector<ParameterName>& names);
  static void setIndex(RegisteredFunction& entry, const std::string& enumeration);

  std::map<std::string, RegisteredFunction> inputs_;
  std::map<std::string, RegisteredFunction> outputs_;
  std::map<std::string, RegisteredFunction> behaviors_;
  std::map<std::string, RegisteredEnumeration> enumerations_;
};

}  // namespace xabsl
