#pragma once

#include <vector>

#include "xabsl/engine/Symbols.h"
#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// The C++ functions of a model's symbols and basic behaviors, by the model's indices.
struct Bindings {
  struct Bound {
    Function function;
    std::vector<int> order;  ///< the argument of the function that each parameter becomes
    std::function<void(const double* arguments)> parametersChanged;  ///< may be empty
  };

  std::vector<Bound> symbols;  ///< without functions for internal symbols
  std::vector<Bound> behaviors;
  std::vector<std::vector<double>>
      elements;  ///< per enumeration: the registered value of each element
  /// Per enumeration: the first value of symbols and parameters. As in the engines of others it is
  /// the element that was registered first, independent of the order in XABSL.
  std::vector<double> firstElements;
};

/// Looks up all declarations of a model among the registered symbols. A symbol that is missing or
/// of another type is an error at its declaration, which names the option that needs it. The
/// bindings are valid only if there is no error.
Bindings link(const Model& model, const Symbols& symbols, std::vector<Diagnostic>& diagnostics);

}  // namespace xabsl
