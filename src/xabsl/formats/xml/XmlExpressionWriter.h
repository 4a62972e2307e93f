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

/// The part of the XML writer for expressions. Traverses the syntax tree for order and spelling;
/// types come from the model.
class XmlExpressionWriter {
 protected:
  XmlExpressionWriter(const syntax::Program& program, const Model& model, Dialect dialect,
                      Reporter& reporter)
      : program_(program), model_(model), reporter_(reporter), old_(dialect == Dialect::xabsl21) {}

  void expression(const syntax::Expression& source);
  /// Writes an element that refers to an entity with parameters, with an `inner` element for each
  /// argument.
  void call(const std::string& element, const char* inner, std::string_view name,
            const std::vector<Parameter>& parameters,
            const std::vector<syntax::Argument>& arguments);

  /// Records that the present option uses declarations of a namespace.
  void use(int space, bool behaviors);
  /// Reports a construct that XABSL 2.1 cannot express, each once, because actions common to all
  /// states are written in each state.
  void refuse(Location location, const std::string& what);
  const Expression& resolved(const syntax::Expression& source) const {
    return model_.expressions[at(source.resolved)];
  }

  /// The prefix of the names of XML elements for a type.
  static std::string kindOf(ValueKind kind);
  static std::string qualified(const syntax::Enumeration& enumeration, std::string_view element);
  /// In 2.1, elements get the name of their enumeration as a prefix, if it differs from that of the
  /// symbol, so that symbols of one type have one type again after reading.
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
  /// Namespaces that the present option uses; the second value: whether it uses their basic
  /// behaviors.
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
