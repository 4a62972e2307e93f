#pragma once

#include <compare>
#include <map>
#include <set>
#include <vector>

#include "xabsl/language/Model.h"

namespace xabsl::documentation {

/// An entity that options use: an index into the list of the model that `kind` selects.
struct Thing {
  enum class Kind {
    read,
    written,
    option,
    behavior,
    constant,
    element
  };  ///< read, written: symbols

  Kind kind = Kind::read;
  int index = -1;
  int element = -1;  ///< of the enumeration `index`

  auto operator<=>(const Thing&) const = default;
};

/// The entity that an action calls or sets.
inline Thing thingOf(const Action& action) {
  using Kind = Action::Kind;
  return {action.kind == Kind::assignment ? Thing::Kind::written
          : action.kind == Kind::option   ? Thing::Kind::option
                                          : Thing::Kind::behavior,
          action.target};
}

/// A state that uses something; -1: all states of the option, by its common decision tree or
/// actions.
struct Place {
  int option = -1;
  int state = -1;

  auto operator<=>(const Place&) const = default;
};

/// The usage of entities by the options of a behavior.
class Usage {
 public:
  explicit Usage(const Model& model);

  /// The entities that an option uses directly, with the states that use them.
  const std::map<Thing, std::vector<int>>& direct(int option) const;

  /// All entities that an option uses, directly or through the options that it calls.
  const std::set<Thing>& all(int option) const;

  /// The places that use something, in the order of the model.
  const std::vector<Place>& places(const Thing& thing) const;

 private:
  void add(const Thing& thing, Place place);
  void collect(const Option& option, int index);
  void collect(Branch branch, Place place);
  void collect(Span actions, Place place);
  void collectExpression(int expression, Place place);
  void collectOperands(int first, std::size_t count, Place place);
  const std::set<Thing>& close(int option);

  const Model& model_;
  std::vector<std::map<Thing, std::vector<int>>> direct_;
  std::vector<std::set<Thing>> all_;
  std::map<Thing, std::vector<Place>> places_;
};

}  // namespace xabsl::documentation
