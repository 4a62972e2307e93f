#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "xabsl/formats/SourceWriter.h"
#include "xabsl/formats/XmlOutput.h"
#include "xabsl/language/Model.h"

namespace xabsl {

/// Writes a behavior as XML: walks the syntax tree, which has the comments, the order and the
/// spelling, and beside it the model, which has the types. Both list the same things in the same
/// order. A derived class writes what its dialect expresses differently.
class XmlWriter {
 public:
  virtual ~XmlWriter() = default;

  VirtualFiles write(const std::string& root);

 protected:
  using Attributes = xml::Attributes;

  /// How a dialect spells and lays out what all dialects have.
  struct Style {
    std::string_view space;              ///< of its elements
    std::string_view xincludeSpace;      ///< of inclusions
    std::string_view schemas;            ///< what their names begin with; empty: they are not named
    std::string_view rootDoctype;        ///< of the file with the agents, up to its first entity
    std::string_view functionReference;  ///< to a symbol with parameters
    bool elseIf;                         ///< an element of its own, not an `if` in an `else`
    bool keepsFolders;      ///< of the sources, instead of one folder for each kind of file
    bool keepsConnections;  ///< `&&` below `&&` as it stands, instead of as one
    bool includesAll;       ///< in each option, instead of what it uses
    bool commentsFirst;     ///< before all of an element, instead of before its name
  };

  /// What an option's file may include.
  struct Included {
    std::string entity;
    std::string path;
    std::string_view space;
    bool behaviors;
  };

  /// A decision tree in both forms. Without a source the state stays.
  struct Tree {
    const syntax::Decision* source;
    Branch branch;
  };

  /// An action in both forms.
  struct ActionPair {
    const syntax::Action& source;
    const Action& resolved;
  };

  XmlWriter(const Style& style, const syntax::Program& program, const Model& model,
            Reporter& reporter);

  // --- What a dialect writes in its own way

  virtual void declare(const syntax::Enumeration& enumeration) = 0;
  virtual void declare(const syntax::Symbol& symbol) = 0;
  virtual Attributes attributesOf(const syntax::Constant& constant) const = 0;
  virtual void parameter(const syntax::Parameter& parameter, const std::string& name) = 0;
  virtual void writeOptions();
  virtual std::string optionDoctype(const std::string& entities) const = 0;
  /// Whether each state gets a copy of the decision tree common to all.
  virtual bool copiesCommon(const syntax::Decision& decision) const = 0;
  /// Those of all states.
  virtual void commonActions(const syntax::Option& /*option*/, const Option& /*resolved*/) {}
  virtual void stateActions(const syntax::Option& option, const Option& resolvedOption,
                            const State& resolved) = 0;
  virtual void assignment(const ActionPair& action) = 0;
  virtual void decision(const Tree& tree, const Tree* rest);
  virtual void expression(const syntax::Expression& source, int index);
  virtual std::string digits(const syntax::Expression& source, double value) const = 0;
  /// The digits of a negated number; nothing of any other expression.
  virtual std::optional<std::string> negated(const syntax::Expression& operand,
                                             const Expression& expression) const = 0;
  /// Whether `==` and `!=` have an element of their own for these operands, and that element.
  virtual bool isComparison(const syntax::Expression& source,
                            const Expression& expression) const = 0;
  virtual void comparison(const syntax::Expression& source, int index) = 0;

  // --- What all dialects share

  /// What the names of elements about a type begin with.
  static std::string kindOf(ValueKind kind);
  static std::string qualified(const syntax::Enumeration& enumeration, std::string_view element);
  static Attributes named(const syntax::Declaration& declaration);
  static std::string entityDeclaration(const std::string& name, const std::string& path);
  /// Of the file with the definitions of all options.
  static std::string optionsDeclaration();

  void comments(Location place);
  void comments(const syntax::Extent& extent, const syntax::Name& name);
  void finish(const std::string& path, const std::string& doctype, const std::string& text);
  void function(const std::string& element, const Attributes& attributes, std::string_view owner,
                const std::vector<syntax::Parameter>& parameters);
  std::vector<ActionPair> pairs(const std::vector<syntax::Action>& sources, Span span) const;
  void actions(const std::vector<syntax::Action>& sources, Span span);
  void action(const ActionPair& action);
  void element(std::string_view name, const syntax::Expression& source, int index);
  /// The present option needs what is declared in a namespace.
  void use(int space, bool behaviors);

  const syntax::Program& program_;
  const Model& model_;
  Reporter& reporter_;
  xml::XmlOutput out_;  ///< of the present file
  std::vector<Included> included_;
  /// Namespaces that the present option uses, and whether their basic behaviors.
  std::set<std::pair<std::string_view, bool>> used_;
  const syntax::State* state_ = nullptr;  ///< the present one; none in what is common to all states

 private:
  Attributes rootAttributes(std::string_view schema) const;
  std::string newPath(const std::string& folder, std::string_view name);
  void writeCollection(const Collection& collection);
  void writeDefinitions();
  void writeRoot(const std::string& root);
  void declare(const syntax::Constant& constant);
  void declare(const syntax::Behavior& behavior);
  void writeOption(const syntax::Option& option, const Option& resolved);
  std::pair<std::string, std::string> inclusions(const std::string& folder) const;
  void writeState(const syntax::Option& option, const Option& resolvedOption, const State& resolved,
                  const Tree* common);
  void choice(const Tree& tree, const Tree* rest);
  void transition(std::string_view state);
  void constant(const syntax::Expression& source, const Expression& expression);
  void number(const std::string& value);
  void symbol(const syntax::Expression& source, const Expression& expression);
  void arguments(const std::string& element, const char* inner, std::string_view name,
                 const std::vector<Parameter>& parameters,
                 const std::vector<syntax::Argument>& arguments, int first);
  void negation(const syntax::Expression& source, const Expression& expression);
  void conditional(const syntax::Expression& source, const Expression& expression);
  void operation(const syntax::Expression& source, int index);
  void operands(const syntax::Expression& source, int index);

  const Style style_;
  LooseComments comments_;
  VirtualFiles files_;
  std::vector<std::string> paths_;  ///< of the options
};

/// What `writeXml` does, for one dialect.
VirtualFiles writeXml21(const syntax::Program& program, const Model& model, const std::string& root,
                        Reporter& reporter);
VirtualFiles writeXml31(const syntax::Program& program, const Model& model, const std::string& root,
                        Reporter& reporter);

}  // namespace xabsl
