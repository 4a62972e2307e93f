#include <utility>

#include "xabsl/language/Parser.h"

/// The part of the parser for declarations in namespaces: symbols, constants, enumerations and
/// basic behaviors.
namespace xabsl {

using namespace syntax;

void Parser::namespaceBlock() {
  const Declaration declaration = begin();
  Namespace& space = program_.namespaces.emplace_back();
  static_cast<Declaration&>(space) = declaration;
  enter(Block::space);
  take();
  try {
    space.name = expectName("the name of a namespace");
    if (std::exchange(hasNamespace_, true))
      warnOfDialect(space.name.location, "a second namespace in this file");
    expect("(");
    if (token_.kind != TokenKind::string) failExpected("the title of the namespace in quotes");
    space.title = take().text;
    expect(")");
    expect("{");
    namespaceBody();
  } catch (const SyntaxError&) {
    skipToDeclaration();
    space.extent.end = end_;
    throw;
  }
}

/// Reads the body of the last namespace and its closing brace.
void Parser::namespaceBody() {
  Namespace& space = program_.namespaces.back();
  space_ = static_cast<int>(program_.namespaces.size()) - 1;
  namespaceMembers();
  closed_ = accept("}");
  space.extent.end = end_;
  space_ = -1;
  accept(";");
}

void Parser::namespaceMembers() {
  while (!token_.is("}") && token_.kind != TokenKind::end && !reporter_.full()) {
    try {
      namespaceMember();
    } catch (const SyntaxError&) {
      skipToMember();
      if (atDeclaration()) return;
    }
  }
  if (!token_.is("}") && !reporter_.full()) {
    program_.namespaces.back().extent.end = end_;
    space_ = -1;
    failExpected("'}'");
  }
}

/// A namespace holds symbols or basic behaviors, never both (they are files of different kinds in
/// XML).
void Parser::enterNamespace(Namespace::Kind kind, Location location) {
  Namespace& space = program_.namespaces[at(space_)];
  if (space.kind != Namespace::Kind::empty && space.kind != kind)
    reporter_.warning(location, "namespace '" + std::string(space.name.text) +
                                    "' has symbols and basic behaviors, expected one kind only");
  if (space.kind == Namespace::Kind::empty) space.kind = kind;
}

void Parser::namespaceMember() {
  const Declaration declaration = begin();
  const bool behaviors = token_.is("behavior");
  if (behaviors || token_.kind == TokenKind::keyword)
    enterNamespace(behaviors ? Namespace::Kind::behaviors : Namespace::Kind::symbols,
                   token_.location);
  if (behaviors) return behavior();
  if (token_.is("enum")) return enumeration();
  if (token_.is("const")) return constant(declaration);
  TypeName type;
  const bool typed = typeName(type);
  if (token_.is("const")) {
    if (type.kind != ValueKind::number) fail("constants are of type float");
    return constant(declaration);
  }
  if (token_.is("input") || token_.is("output") || token_.is("internal"))
    return symbol(declaration, type);
  failExpected(typed ? "'input', 'output' or 'internal'"
                     : "a declaration of a symbol, a constant, an enumeration or a behavior");
}

/// `enum` starts a declaration of an enumeration, or of a symbol of that type.
void Parser::enumeration() {
  const Declaration declaration = begin();
  take();
  const Name name = expectName("the name of an enumeration");
  if (accept("{")) return enumerationElements(declaration, name, false);
  if (!token_.is("input") && !token_.is("output") && !token_.is("internal"))
    failExpected("'{', 'input', 'output' or 'internal'");
  symbol(declaration, {ValueKind::enumeration, name});
}

void Parser::enumerationElements(const Declaration& declaration, const Name& name, bool internal) {
  Enumeration enumeration;
  static_cast<Declaration&>(enumeration) = declaration;
  enumeration.name = name;
  enumeration.internal = internal;
  try {
    do enumeration.elements.push_back(expectName("the name of an element"));
    while (accept(","));
    if (!token_.is("}")) failExpected("',' or '}'");
  } catch (const SyntaxError&) {
    while (!atDeclaration() && !atType() && !atSymbol() && !token_.is("}") && !token_.is(";"))
      take();
  }
  accept("}");
  if (!accept(";")) warnOfDialect(end_, "an enumeration without ';' behind it");
  enumeration.extent.end = end_;
  program_.enumerations.push_back(std::move(enumeration));
}

void Parser::constant(const Declaration& declaration) {
  take();
  Constant constant;
  static_cast<Declaration&>(constant) = declaration;
  constant.name = expectName("the name of a constant");
  finish(program_.constants, constant, [&] {
    expect("=");
    constant.negative = accept("-");
    if (token_.kind != TokenKind::number) failExpected("a number");
    warnOfExponent();
    constant.digits = token_.text;
    constant.value = constant.negative ? -token_.number : token_.number;
    take();
    unitAndRange(constant.range, constant.unit);
    expectSemicolon();
  });
}

void Parser::symbol(const Declaration& declaration, const TypeName& type) {
  Symbol symbol;
  static_cast<Declaration&>(symbol) = declaration;
  symbol.type = type;
  symbol.kind = token_.is("input")    ? SymbolKind::input
                : token_.is("output") ? SymbolKind::output
                                      : SymbolKind::internal;
  take();
  if (symbol.kind == SymbolKind::internal) accept("output");  // as some tools write it
  // `enum E input { a, b }` declares the enumeration: what it is used for is seen from its use.
  if (type.kind == ValueKind::enumeration && accept("{"))
    return enumerationElements(declaration, type.enumeration, symbol.kind == SymbolKind::internal);
  symbol.name = expectName("the name of a symbol");
  finish(program_.symbols, symbol, [&] {
    const Location unit = token_.location;
    unitAndRange(symbol.range, symbol.unit);
    if (type.kind == ValueKind::enumeration && !symbol.unit.empty())
      warnOfDialect(unit, "the unit of an enumerated symbol");
    if (token_.is("(")) {
      if (symbol.kind != SymbolKind::input)
        reporter_.error(token_.location, "only input symbols have parameters");
      take();
      parameters(symbol.parameters, ")");
    }
    expectSemicolon();
  });
}

void Parser::behavior() {
  Behavior behavior;
  static_cast<Declaration&>(behavior) = begin();
  take();
  behavior.name = expectName("the name of a basic behavior");
  finish(program_.behaviors, behavior, [&] {
    expect("{");
    parameters(behavior.parameters, "}");
  });
  accept(";");
}

bool Parser::typeName(TypeName& type) {
  if (accept("float")) return true;
  if (accept("bool")) {
    type.kind = ValueKind::boolean;
    return true;
  }
  if (!accept("enum")) return false;
  type.kind = ValueKind::enumeration;
  type.enumeration = expectName("the name of an enumeration");
  return true;
}

void Parser::parameters(std::vector<Parameter>& parameters, std::string_view close) {
  while (!token_.is(close)) {
    try {
      parameters.push_back(parameter(false));
    } catch (const SyntaxError&) {
      skipToMember();
      const bool another = atType() || token_.kind == TokenKind::identifier;
      if (reporter_.full() || (!another && !token_.is(close))) throw;
    }
  }
  take();
}

Parameter Parser::parameter(bool ofOption) {
  Parameter parameter;
  static_cast<Declaration&>(parameter) = begin();
  typeName(parameter.type);
  if (ofOption) {
    if (token_.kind != TokenKind::parameter)
      failExpected("the name of a parameter, as in '@speed'");
    const Token name = take();
    parameter.name = {name.text, name.location};
  } else {
    parameter.name = expectName("the name of a parameter");
  }
  unitAndRange(parameter.range, parameter.unit);
  expectSemicolon();
  parameter.extent.end = end_;
  return parameter;
}

/// Range and unit are documentation. The unit follows the range; it may also stand before it.
void Parser::unitAndRange(std::string_view& range, std::string_view& unit) {
  if (token_.kind == TokenKind::range) range = take().text;
  if (token_.kind == TokenKind::string) unit = take().text;
  if (token_.kind != TokenKind::range) return;
  warnOfDialect(token_.location, "a range behind the unit");
  range = take().text;
}

}  // namespace xabsl
