#pragma once

#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "xabsl/formats/xml/XmlOutput.h"
#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

/// The part of the XML writer for expressions. Walks the syntax tree, which has the order and the
/// spelling; the model has the types.
class XmlExpressionWriter {
 protected:
  XmlExpressionWriter(const syntax::Program& program, const Model& model, Dialect dialect,
                      Reporter& reporter)
      : program_(program), model_(model), reporter_(reporter), old_(dialect == Dialect::xabsl21) {}

  void expression(const syntax::Expression& source);
  /// An element that refers to what has these parameters, with an `inner` one for each argument.
  void call(const std::string& element, const char* inner, std::string_view name,
            const std::vector<Parameter>& parameters,
            const std::vector<syntax::Argument>& arguments);

  /// The present option needs what is declared in a namespace.
  void use(int space, bool behaviors);
  /// Reports what XABSL 2.1 cannot express, each once: actions common to all states are written in
  /// each of them.
  void refuse(Location location, const std::string& what);
  const Expression& resolved(const syntax::Expression& source) const {
    return model_.expressions[at(source.resolved)];
  }

  /// What the names of elements about a type begin with.
  static std::string kindOf(ValueKind kind);
  static std::string qualified(const syntax::Enumeration& enumeration, std::string_view element);
  /// In 2.1, elements have the name of their enumeration before them, if it is not that of the
  /// symbol: so symbols of one type are of one type again.
  static std::string elementName(std::string_view symbol, const syntax::Enumeration& enumeration,
                                 std::string_view element);
  std::string elementName(std::string_view symbol, const Expression& element) const;
  /// A number without exponent, which the schema of 2.1 does not know.
  static std::string withoutExponent(std::string_view text);

  const syntax::Program& program_;
  const Model& model_;
  Reporter& reporter_;
  const bool old_;      ///< XABSL 2.1, otherwise 3.1
  xml::XmlOutput out_;  ///< of the present file
  /// Namespaces that the present option uses, and whether their basic behaviors.
  std::set<std::pair<std::string_view, bool>> used_;

 private:
  std::string_view missingFor(const Expression& expression) const;
  void constant(const syntax::Expression& source);
  void number(const std::string& value);
  void symbol(const syntax::Expression& source);
  void negation(const syntax::Expression& source);
  void conditional(const syntax::Expression& source);
  void operation(const syntax::Expression& source);
  void equality(const syntax::Expression& source, const std::string& element);
  void operands(const syntax::Expression& source);

  std::set<std::tuple<int, int, int, std::string>> refused_;
};

}  // namespace xabsl
