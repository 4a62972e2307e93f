#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Model.h"
#include "xabsl/language/Names.h"
#include "xabsl/language/References.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

/// The name of a type in messages: `float`, `bool` or `enum E`.
std::string describe(const Model& model, Type type);

/// The index of a parameter by its name, with or without `owner.` before it; -1 if there is none.
int findParameter(const std::vector<Parameter>& parameters, std::string_view name,
                  std::string_view owner);

/// Resolves names and checks types of the expressions of one option and appends them to the model.
class ExpressionAnalyzer {
 public:
  ExpressionAnalyzer(Model& model, const Names& names, int option, Reporter& reporter,
                     References* references = nullptr);

  /// The index of the resolved expression, or -1 after an error. `purpose` is the beginning of the
  /// message about a wrong type.
  int expression(syntax::Expression& source, Type wanted, const std::string& purpose);

  /// Resolves `name = value, ...`; parameters not given become 0, false or the first element
  /// (report F.6). `entity` is the owner of the parameters. Returns the index of the first operand.
  int arguments(const std::vector<syntax::Argument>& sources,
                const std::vector<Parameter>& parameters, std::string_view owner,
                const std::string& callee, const Entity& entity);

  void error(Location location, const std::string& message);

 private:
  struct Typed {
    int index = -1;  ///< -1: an error, already reported
    Type type;
  };

  Typed analyze(syntax::Expression& source, int enumeration);
  Typed name(syntax::Expression& source, int enumeration);
  void ambiguous(syntax::Expression& source, bool constant, bool input, bool output);
  Typed symbol(syntax::Expression& source, int index);
  Typed element(syntax::Expression& source, int enumeration);
  Typed parameter(syntax::Expression& source);
  Typed call(syntax::Expression& source);
  Typed operation(syntax::Expression& source, int enumeration);
  Typed equality(syntax::Expression& source);
  Typed conditional(syntax::Expression& source, int enumeration);
  Typed uniform(syntax::Expression& source, Type operandType, Type resultType);
  bool isDeclared(Type type) const;
  void refer(const Entity& entity, syntax::Expression& source);
  Typed add(syntax::Expression& source, const Expression& expression, Type type);
  int appendOperands(const std::vector<int>& operands, const std::vector<int>& order = {});
  void unknownName(syntax::Expression& source, int enumeration);

  Model& model_;
  const Names& names_;
  int option_;
  Reporter& reporter_;
  References* references_;
};

}  // namespace xabsl
