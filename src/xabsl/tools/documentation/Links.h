#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Model.h"
#include "xabsl/tools/documentation/Usage.h"

namespace xabsl::documentation {

/// The addresses of all entities in the documentation: the names of the pages, and the fragments
/// behind `#` within them.
class Links {
 public:
  explicit Links(const Model& model);

  std::string agent(int agent) const;
  std::string option(int option) const;
  std::string state(int state) const;
  std::string commonDecision(int option) const;
  /// Namespace -1 contains the declarations outside of namespaces.
  std::string space(int space) const;
  std::string symbol(int symbol) const;
  std::string constant(int constant) const;
  std::string enumeration(int enumeration) const;
  std::string behavior(int behavior) const;
  std::string target(const Thing& thing) const;

  /// The option that a state belongs to.
  int optionOf(int state) const { return optionOfState_[at(state)]; }

  /// The beginning of a symbol's fragment, because an input and an output may have the same name.
  static std::string_view kindOf(const Symbol& symbol);

  /// `#kind-name`, without the `#`; also the identifier in HTML.
  static std::string fragment(std::string_view kind, std::string_view name);

 private:
  const Model& model_;
  std::vector<std::string> spaces_;
  std::vector<int> optionOfState_;
};

}  // namespace xabsl::documentation
