#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "xabsl/formats/XmlOutput.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"

namespace xabsl {

/// Writes the expressions of a program in the XML of XABSL 2.1 (report F.8, F.9), and knows under
/// which names things stand there. What XABSL 2.1 cannot say is told as an error.
class XmlExpressionWriter {
 public:
  XmlExpressionWriter(const syntax::Program& program, Reporter& reporter, xml::XmlOutput& out);

  /// Parameters of this option are meant from now on.
  void enter(const syntax::Option& option) { option_ = &option; }
  void write(const syntax::Expression& expression);
  /// An element that refers to a declaration, with the values of its parameters in inner ones.
  void writeValues(const char* element, const char* inner, std::string_view ref,
                   const std::vector<syntax::Argument>& arguments);
  void cannot(Location location, const std::string& what);

  /// The output symbol of a name, or null.
  const syntax::Symbol* output(std::string_view name) const { return find(outputs_, name); }
  const syntax::Enumeration* enumerationOf(const syntax::Symbol& symbol) const;
  bool isOption(std::string_view name) const { return options_.count(name) > 0; }

  /// Elements bear the name of their enumeration, if it is not that of the symbol: so symbols of
  /// one type are of one type again.
  static std::string elementName(const syntax::Symbol& symbol,
                                 const syntax::Enumeration& enumeration, std::string_view element);
  static bool isElement(const syntax::Enumeration& enumeration, const syntax::Expression& value);
  /// A number without exponent, which the schema does not know.
  static std::string digits(std::string_view text);

 private:
  using SymbolTable = std::map<std::string_view, const syntax::Symbol*>;

  static const syntax::Symbol* find(const SymbolTable& table, std::string_view name);
  void reference(const syntax::Expression& expression);
  void operation(const syntax::Expression& expression);
  void negation(const syntax::Expression& expression);
  void conditional(const syntax::Expression& expression);
  /// An enumerated symbol compared with one of its elements.
  bool comparison(const syntax::Expression& expression);

  Reporter& reporter_;
  xml::XmlOutput& out_;
  SymbolTable inputs_;
  SymbolTable outputs_;  // and internal symbols
  std::map<std::string_view, const syntax::Enumeration*> enumerations_;
  std::set<std::string_view> constants_;
  std::set<std::string_view> options_;
  const syntax::Option* option_ = nullptr;
  std::set<std::tuple<int, int, int, std::string>> told_;
};

}  // namespace xabsl
