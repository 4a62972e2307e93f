#pragma once

#include <compare>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

/// A declared entity, by its index in the lists of the model.
struct Entity {
  enum class Kind {
    space,
    enumeration,
    element,  ///< part: of the enumeration
    symbol,
    constant,
    behavior,
    option,
    state,
    agent,
    symbolParameter,  ///< part: of the symbol, and so on
    behaviorParameter,
    optionParameter
  };

  Kind kind = Kind::symbol;
  int index = -1;
  int part = -1;

  auto operator<=>(const Entity&) const = default;
};

/// A place where a name refers to a declared entity. The text is a view into the source.
struct Reference {
  Entity entity;
  std::string_view text;
  Location location;
  bool declares = false;
};

/// Collects names with their places and entities, for editors; the Analyzer adds the uses.
class References {
 public:
  /// Adds the declarations of a program.
  void declare(const syntax::Program& program);

  void add(const Entity& entity, std::string_view text, Location location);

  /// Adds a name, and the name of its owner if it is written before it, as in `owner.name`.
  void addQualified(const Entity& owner, const Entity& entity, std::string_view text,
                    Location location, std::size_t ownerLength);

  const std::vector<Reference>& all() const { return all_; }

 private:
  void declare(const Entity& entity, const syntax::Name& name);
  void declareParameters(Entity::Kind kind, int owner,
                         const std::vector<syntax::Parameter>& parameters);

  std::vector<Reference> all_;
};

}  // namespace xabsl
