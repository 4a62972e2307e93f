#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "xabsl/engine/Symbols.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// Registers all declarations of a model as variables of its own, for tools and tests without a
/// robot. The values of elements are their indices. Must outlive the engines that use it.
class VirtualSymbols {
 public:
  /// Computes the value of an input symbol with parameters; arguments are in the order of the
  /// declaration.
  using Call = std::function<double(int symbol, const double* arguments)>;

  explicit VirtualSymbols(const Model& model, Call call = {});
  VirtualSymbols(const VirtualSymbols&) = delete;
  VirtualSymbols& operator=(const VirtualSymbols&) = delete;

  const Symbols& symbols() const { return symbols_; }

  /// The value of an input symbol, or the last value set to an output symbol.
  double& value(int symbol) { return entries_[at(symbol)].value; }

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
