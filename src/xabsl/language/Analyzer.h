#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/Names.h"
#include "xabsl/language/References.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

/// Resolves a syntax tree into a model: resolves names, checks types and the rules of the language.
/// Expressions and actions of the tree get the indices of those in the model.
class Analyzer {
 public:
  /// Resolved names are added to `references`, if that is given.
  Analyzer(syntax::Program& program, Reporter& reporter, References* references = nullptr);

  /// Returns the model, which is valid only if the reporter has not failed.
  Model analyze();

 private:
  void describeProgram();
  void declareEnumerations();
  void declareSymbols();
  void declareConstants();
  void declareBehaviors();
  void declareOptions();
  void declareStates(const syntax::Option& source, Option& option);
  void declareAgents();
  void declare(Names::Table& table, const syntax::Name& name, int index, const std::string& what);
  void refer(const Entity& entity, const syntax::Name& name);
  void resolve(const syntax::TypeName& source, Type& type);
  std::vector<Parameter> resolve(const std::vector<syntax::Parameter>& sources);
  void unknown(const Names::Table& table, const syntax::Name& name, const std::string& what);

  void resolveOption(syntax::Option& source, int index);
  void checkElse(const syntax::Option& option, const syntax::State& state);
  Branch branch(const syntax::Decision& source, ExpressionAnalyzer& expressions);
  Branch transition(const syntax::Name& target, ExpressionAnalyzer& expressions);
  Span actions(std::vector<syntax::Action>& sources, int option, ExpressionAnalyzer& expressions);
  bool assignment(const syntax::Action& source, int option, ExpressionAnalyzer& expressions,
                  Action& action);
  bool call(const syntax::Action& source, int option, ExpressionAnalyzer& expressions,
            Action& action);
  void unknownCallee(const syntax::Action& source, ExpressionAnalyzer& expressions);

  syntax::Program& program_;
  Reporter& reporter_;
  References* references_;
  Names names_;
  Names::Table states_;  ///< of the option that is being resolved
  Model model_;
};

}  // namespace xabsl
