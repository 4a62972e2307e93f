#pragma once
#include <exception>
#include <memory>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/Random.h"
#include "debug/Debug.h"
#include "framework/Blackboard.h"
#include "streams/Config.h"

namespace gt {

/// A representation as it was at the end of the last cycle, for modules that need the output of
/// modules that run later.
template <typename T>
struct Previous {
  const T& value;

  const T* operator->() const { return &value; }
  const T& operator*() const { return value; }
};

/// How a module uses a representation.
enum class PortKind { input, previous, output };

/// One parameter of a module's update().
struct Port {
  PortKind kind;
  const RepresentationType* type;
};

/// Services that a module may use besides representations.
struct ModuleContext {
  Blackboard& blackboard;
  Debug& debug;
  Random random;
};

namespace detail {

/// Binds a parameter of update(): the constructor binds it once, and each cycle passes it.
template <typename A>
struct Binding {
  static_assert(!std::is_same_v<A, A>,
                "update() of a module takes inputs as const T&, outputs as T&, values of the last "
                "cycle as Previous<T>, and Random& or Debug&; nothing else, and nothing by value");
  explicit Binding(ModuleContext&);
  A use();
  static void list(std::vector<Port>&);
};

template <typename T>
struct Binding<const T&> {
  explicit Binding(ModuleContext& context) : slot{context.blackboard.slot(representation<T>())} {}
  const T& use() { return *static_cast<const T*>(slot.value.get()); }
  static void list(std::vector<Port>& ports) {
    ports.push_back({PortKind::input, &representation<T>()});
  }
  const Blackboard::Slot& slot;  ///< Shared configuration may be replaced by other values.
};

template <typename T>
struct Binding<T&> {
  explicit Binding(ModuleContext& context)
      : value{*static_cast<T*>(context.blackboard.own(representation<T>()))} {}
  T& use() { return value; }
  static void list(std::vector<Port>& ports) {
    ports.push_back({PortKind::output, &representation<T>()});
  }
  T& value;
};

template <typename T>
struct Binding<Previous<T>> {
  explicit Binding(ModuleContext& context)
      : now{*static_cast<const T*>(context.blackboard.own(representation<T>()))}, before{now} {}
  Previous<T> use() {
    before = now;  // a copy, since update() may overwrite it while it reads
    return {before};
  }
  static void list(std::vector<Port>& ports) {
    ports.push_back({PortKind::previous, &representation<T>()});
  }
  const T& now;
  T before;
};

template <>
struct Binding<Debug&> {
  explicit Binding(ModuleContext& context) : debug{context.debug} {}
  Debug& use() { return debug; }
  static void list(std::vector<Port>&) {}
  Debug& debug;
};

template <>
struct Binding<Random&> {
  explicit Binding(ModuleContext& context) : random{context.random} {}
  Random& use() { return random; }
  static void list(std::vector<Port>&) {}
  Random& random;
};

/// Combines several inputs in one parameter: a struct of references, whose `Parts` are their types.
template <typename T>
concept Bundle = requires {
  typename T::Parts;
};

template <typename T, typename Parts>
struct BundleBinding;
template <typename T, typename... A>
struct BundleBinding<T, std::tuple<A...>> {
  explicit BundleBinding(ModuleContext& context) : parts{Binding<A>{context}...} {}
  T use() {
    return std::apply([](auto&... part) { return T{part.use()...}; }, parts);
  }
  static void list(std::vector<Port>& ports) { (Binding<A>::list(ports), ...); }
  std::tuple<Binding<A>...> parts;
};
template <Bundle T>
struct Binding<T> : BundleBinding<T, typename T::Parts> {
  using BundleBinding<T, typename T::Parts>::BundleBinding;
};

template <typename M>
concept HasParameters = requires(M m) {
  m.parameters;
};
template <typename M>
concept HasOneUpdate = requires {
  &M::update;
};

/// The parameters of a module's update().
template <typename Update>
struct Signature {
  static_assert(!std::is_same_v<Update, Update>,
                "update() of a module returns void, and is neither static nor noexcept");
  using Arguments = std::tuple<>;
};
template <typename M, typename... A>
struct Signature<void (M::*)(A...)> {
  using Arguments = std::tuple<A...>;
};
template <typename M, typename... A>
struct Signature<void (M::*)(A...) const> {
  using Arguments = std::tuple<A...>;
};

template <typename M>
struct Ports {
  static_assert(HasOneUpdate<M>,
                "a module has one member function update(), which is neither overloaded nor a "
                "template");
  using Arguments = std::tuple<>;
};
template <HasOneUpdate M>
struct Ports<M> : Signature<decltype(&M::update)> {};

}  // namespace detail

/// Thrown by a module that failed and cannot continue: one written by a user in another language.
/// Modules in C++ do not throw. The process switches to the solution `instead`.
class ModuleFailure : public std::exception {
 public:
  ModuleFailure(std::string why, std::string instead)
      : why_{std::move(why)}, instead_{std::move(instead)} {}

  const char* what() const noexcept override { return why_.c_str(); }
  const std::string& instead() const { return instead_; }

 private:
  std::string why_, instead_;
};

/// A module as seen by the framework: one solution of a task, bound to the representations of its
/// process.
class AnyModule {
 public:
  virtual ~AnyModule() = default;
  /// Executes update() once. May only throw a ModuleFailure.
  virtual void run() = 0;
  /// Reads the parameters from a configuration file's text. An error leaves them unchanged.
  virtual Findings configure(std::string_view text, std::string_view file) = 0;
  /// Sets one parameter by its path, for instance "gain" or "noise.translation".
  virtual Result<void> set(std::string_view path, std::string_view value) = 0;
  virtual Result<std::string> get(std::string_view path) = 0;
  virtual std::vector<PathInfo> parameters() = 0;
  /// Takes over parameters and internal state from another module of the same class. Returns false
  /// if the class differs.
  virtual bool adopt(AnyModule& other) = 0;
};

/// Makes a module from a plain class: its ports are the parameters of its update().
template <typename M, typename Arguments = typename detail::Ports<M>::Arguments>
class ModuleAdapter;

template <typename M, typename... A>
class ModuleAdapter<M, std::tuple<A...>> final : public AnyModule {
 public:
  explicit ModuleAdapter(ModuleContext context)
      : context_{std::move(context)}, bindings_{detail::Binding<A>{context_}...} {}

  void run() override {
    std::apply([this](auto&... binding) { module_->update(binding.use()...); }, bindings_);
  }
  Findings configure(std::string_view text, std::string_view file) override {
    if constexpr (detail::HasParameters<M>) {
      return collectConfig(text, std::string{file}, module_->parameters);
    } else {
      Findings findings;
      findings.add(Error{.file = std::string{file}, .what = "this module has no parameters"});
      return findings;
    }
  }
  Result<void> set(std::string_view path, std::string_view value) override {
    if constexpr (detail::HasParameters<M>)
      return setByPath(module_->parameters, path, value);
    else
      return Error{.field = std::string{path}, .what = "this module has no parameters"};
  }
  Result<std::string> get(std::string_view path) override {
    if constexpr (detail::HasParameters<M>)
      return getByPath(module_->parameters, path);
    else
      return Error{.field = std::string{path}, .what = "this module has no parameters"};
  }
  bool adopt(AnyModule& other) override {
    auto* same = dynamic_cast<ModuleAdapter*>(&other);
    if (!same) return false;
    std::swap(module_, same->module_);
    context_.random = same->context_.random;
    return true;
  }
  std::vector<PathInfo> parameters() override {
    if constexpr (detail::HasParameters<M>)
      return paths(module_->parameters);
    else
      return {};
  }
  static std::vector<Port> ports() {
    std::vector<Port> list;
    (detail::Binding<A>::list(list), ...);
    return list;
  }

 private:
  std::unique_ptr<M> module_ = std::make_unique<M>();
  ModuleContext context_;
  std::tuple<detail::Binding<A>...> bindings_;
};

}  // namespace gt
