#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/formats/xml/XmlTree.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl::xml {

/// Converts the files of a behavior in XABSL 2.1 or 3.1, which are valid by the schema, to the
/// syntax tree (report F). Checks rules that a schema cannot express: references must name entities
/// that the file of the option includes, and prototypes must match.
class Parser {
 public:
  Parser(const Files& files, Reporter& reporter, syntax::Program& program);

  void parse();

 private:
  /// The entries of a collection by their names.
  using Entries = std::multimap<std::string_view, const Element*>;

  void agentCollection(const Element& root);
  void agent(const Element& element);
  void collect(const Element& option);
  bool isNew(const Element& collection, const std::string& key);
  void declare(const Element& collection);
  void symbols(const Element& element);
  void symbol(const Element& element, int space);
  void enumeration(const Element& element, int space);
  static syntax::TypeName type(const Element& element);
  void enumeratedSymbol(const Element& element, int space);
  void constant(const Element& element, int space);
  void behavior(const Element& element, int space);
  int enterNamespace(const Element& element, syntax::Namespace::Kind kind);
  void checkFileName(const Element& element, std::string_view name, const std::string& attribute);
  std::vector<syntax::Parameter> parameters(const Element& owner);
  /// The common part of all declarations; `key` is the attribute with the name.
  template <typename Declared>
  static Declared declared(const Element& element, std::string_view key, int space = -1) {
    const Attribute* name = element.find(key);
    Declared result;
    static_cast<syntax::Declaration&>(result) = {{name->value, name->location},
                                                 element.attribute("description"),
                                                 {element.location, element.location},
                                                 space};
    return result;
  }
  void comments();

  void option(const Element& element);
  void markInitialState(const Element& element, syntax::Option& option);
  syntax::State state(const Element& element);
  Cooperation cooperation(const Element& state);
  void actions(const Element& parent, std::vector<syntax::Action>& actions);
  syntax::Action setOutputSymbol(const Element& element);
  syntax::Action assignment(const Element& element);
  syntax::Action subsequent(const Element& element);
  std::vector<syntax::Argument> arguments(const Element& element);
  syntax::DecisionPtr statement(const Element& parent);
  syntax::Arm arm(const Element& element);
  syntax::ExpressionPtr expression(const Element& element);
  syntax::ExpressionPtr operation(const Element& element, Operator operation);
  syntax::ExpressionPtr inputSymbol(const Element& element);
  syntax::ExpressionPtr functionCall(const Element& element, std::string_view kind);
  syntax::ExpressionPtr reference(const Element& element);
  syntax::ExpressionPtr enumElement(const Element& element);
  syntax::ExpressionPtr optionParameter(const Element& element);
  syntax::ExpressionPtr comparison(const Element& element);
  syntax::ExpressionPtr number(const Element& element);

  void checkElement(const Element& element, const Element& symbol);
  const Element* refer(const Element& element, std::string_view kind);
  void unknown(const Element& element, std::string_view kind);
  const Entries& entriesOf(const Element& collection);
  std::vector<const Element*> elementsOf(const Element& parent) const;
  void error(const Element& element, std::string_view attribute, const std::string& message);

  const Files& files_;
  Reporter& reporter_;
  syntax::Program& program_;
  std::map<std::string, const Element*> collections_;  ///< by kind and id
  std::map<const Element*, Entries> entries_;
  std::map<std::string_view, const Element*> prototypes_;
  std::set<std::string_view> notInputs_;  ///< names of output symbols, constants and elements
  std::vector<const Element*> visible_;   ///< the collections that the present option includes
  std::string_view option_;
};

/// A boolean value of the schema.
constexpr bool isTrue(std::string_view value) {
  return value == "true" || value == "1";
}

}  // namespace xabsl::xml
