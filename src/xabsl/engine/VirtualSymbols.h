#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "xabsl/engine/Symbols.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// Surroundings for a behavior that has none: all that a model declares, as data. Elements have
/// their indices as values. For tools and tests; must outlive the engines that use it.
class VirtualSymbols {
 public:
  /// The value of an input symbol with parameters; arguments in the order of the declaration.
  using Call = std::function<double(int symbol, const double* arguments)>;

  explicit VirtualSymbols(const Model& model, Call call = {});
  VirtualSymbols(const VirtualSymbols&) = delete;
  VirtualSymbols& operator=(const VirtualSymbols&) = delete;

  const Symbols& symbols() const { return symbols_; }

  /// The value of an input symbol, or what an output symbol was set to last.
  double& value(int symbol) { return entries_[static_cast<std::size_t>(symbol)].value; }

 private:
  struct Entry {
    VirtualSymbols* owner;
    int symbol;
    double value = 0;
  };

  RegisteredFunction registered(Entry& entry, const Symbol& symbol);

  std::vector<Entry> entries_;
  Call call_;
  Symbols symbols_;
};

}  // namespace xabsl
