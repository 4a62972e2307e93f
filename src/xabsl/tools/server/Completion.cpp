#include <algorithm>
#include <set>
#include <utility>

#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/language/Text.h"
#include "xabsl/tools/server/Project.h"

namespace xabsl::server {

namespace {

/// The tokens before a place, without the word that is being written there, and the brackets and
/// blocks that they open.
class Context {
 public:
  Context(std::string_view text, std::size_t offset) {
    Reporter ignored;
    ignored.addFile("", text);
    std::size_t begin = std::min(offset, text.size());
    while (begin > 0 && isNamePart(text[begin - 1])) --begin;
    if (begin > 0 && text[begin - 1] == '@') --begin;
    Lexer lexer(0, text, ignored);
    for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
      const bool before = token.text.data() < text.data() + begin;
      if (before) tokens_.push_back(token);
      all_.push_back(token);
    }
    writesParameter_ = begin < text.size() && text[begin] == '@';
    findOption();
  }

  bool writesParameter() const { return writesParameter_; }

  /// The token so many before the place.
  const Token& back(std::size_t count) const {
    static const Token none;
    return count < tokens_.size() ? tokens_[tokens_.size() - 1 - count] : none;
  }

  bool inOption() const { return option_ < all_.size(); }
  std::string_view optionName() const { return inOption() ? all_[option_ + 1].text : ""; }

  /// The states of the option around the place, also those behind it.
  std::set<std::string> states() const {
    std::set<std::string> names;
    for (std::size_t i = option_; i + 1 < all_.size(); ++i) {
      if (i > option_ && all_[i].is("option")) break;
      if (all_[i].is("state") && all_[i + 1].kind == TokenKind::identifier)
        names.insert(std::string(all_[i + 1].text));
    }
    return names;
  }

  /// The keyword of the innermost block: option, state, action, decision, namespace; or nothing.
  std::string_view block() const {
    std::vector<std::string_view> open;
    std::string_view last;
    for (const Token& token : tokens_) {
      for (const std::string_view word :
           {"option", "state", "action", "decision", "namespace", "behavior"})
        if (token.is(word)) last = word;
      if (token.is("{")) open.push_back(std::exchange(last, {}));
      if (token.is("}") && !open.empty()) open.pop_back();
      if (token.is(";")) last = {};
    }
    while (!open.empty() && open.back().empty()) open.pop_back();
    return open.empty() ? std::string_view() : open.back();
  }

  /// The index, counted back, of the token that names what is called around the place; 0: nothing.
  std::size_t callee() const {
    int depth = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (back(i).is(";") || back(i).is("{") || back(i).is("}")) return 0;
      if (back(i).is(")")) ++depth;
      if (!back(i).is("(") || depth-- > 0) continue;
      if (back(i + 1).kind == TokenKind::identifier) return i + 1;
      depth = 0;  // parentheses of an expression or a condition: what is around them counts
    }
    return 0;
  }

  /// The names of the parameters that are set in the call around the place, and last of that being
  /// set; empty: it has no name yet.
  std::vector<std::string_view> arguments() const {
    std::vector<std::string_view> names;
    std::string_view name;
    int depth = 0;
    for (std::size_t i = callee() - 1; i-- > 0;) {
      if (back(i).is("(")) ++depth;
      if (back(i).is(")")) --depth;
      if (depth > 0) continue;
      if (back(i).is("=") && back(i + 1).kind == TokenKind::identifier) name = back(i + 1).text;
      if (back(i).is(",")) names.push_back(std::exchange(name, {}));
    }
    names.push_back(name);
    return names;
  }

 private:
  void findOption() {
    option_ = all_.size();
    for (std::size_t i = 0; i < tokens_.size() && i + 1 < all_.size(); ++i)
      if (all_[i].is("option") && all_[i + 1].kind == TokenKind::identifier &&
          (i + 2 >= all_.size() || all_[i + 2].is("{")))
        option_ = i;
  }

  std::vector<Token> tokens_;
  std::vector<Token> all_;
  std::size_t option_ = 0;  // its first token
  bool writesParameter_ = false;
};

/// The parameters and the documentation of the entity called by a name; null if there is none.
std::pair<const std::vector<Parameter>*, std::string> parametersOf(const Model& model,
                                                                   std::string_view name) {
  for (const Option& option : model.options)
    if (option.name == name) return {&option.parameters, option.doc};
  for (const BasicBehavior& behavior : model.behaviors)
    if (behavior.name == name) return {&behavior.parameters, behavior.doc};
  for (const Symbol& symbol : model.symbols)
    if (symbol.name == name && !symbol.parameters.empty()) return {&symbol.parameters, symbol.doc};
  return {nullptr, {}};
}

class Completer {
 public:
  Completer(const Project& project, const Context& context)
      : project_(project), model_(project.model()), context_(context) {}

  std::vector<Completion> run() {
    const Token& last = context_.back(0);
    if (context_.writesParameter()) {
      optionParameters();
    } else if (last.is("goto")) {
      for (const std::string& state : context_.states()) add(Completion::Kind::state, state, state);
    } else if (last.is("enum")) {
      each(model_.enumerations, Completion::Kind::enumeration, Entity::Kind::enumeration);
    } else if (context_.block().empty()) {
      topLevel();
    } else if (const auto* parameters = calledParameters(); parameters && beginsArgument()) {
      for (const Parameter& parameter : *parameters)
        add(Completion::Kind::parameter, parameter.name, parameter.name + " = ",
            describe(model_, parameter.type));
    } else if (context_.block() == "namespace") {
      keywords({"float", "bool", "enum", "input", "output", "internal", "const", "behavior"});
    } else if (context_.block() == "option") {
      keywords(
          {"initial", "target", "state", "common", "decision", "action", "float", "bool", "enum"});
    } else if (context_.block() == "state") {
      keywords({"decision", "action"});
    } else if (last.is("{") || last.is(";") || last.is("}") || last.is("else") ||
               (last.is(")") && context_.block() == "decision")) {
      statement();
    } else {
      expression();
    }
    return std::move(result_);
  }

 private:
  void add(Completion::Kind kind, const std::string& name, const std::string& insert,
           const std::string& detail = {}, const std::string& doc = {}) {
    result_.push_back({kind, name, insert, detail, doc});
  }

  void keywords(std::initializer_list<const char*> words) {
    for (const char* word : words) add(Completion::Kind::keyword, word, word);
  }

  template <typename List>
  void each(const List& list, Completion::Kind kind, Entity::Kind entity,
            const std::string& behind = {}) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (!list[i].name.empty())
        add(kind, list[i].name, list[i].name + behind,
            signatureOf(project_, {entity, static_cast<int>(i)}), list[i].doc);
  }

  void topLevel() {
    const Token& before = context_.back(0);
    if (before.is(",")) return each(model_.options, Completion::Kind::option, Entity::Kind::option);
    keywords({"include", "agent", "namespace", "option"});
  }

  void optionParameters() {
    for (const Option& option : model_.options)
      if (option.name == context_.optionName())
        for (const Parameter& parameter : option.parameters)
          add(Completion::Kind::parameter, "@" + parameter.name, "@" + parameter.name,
              describe(model_, parameter.type), parameter.doc);
  }

  /// What a decision or an action may begin with.
  void statement() {
    if (context_.block() == "decision") return keywords({"if", "else", "goto", "stay"});
    each(model_.options, Completion::Kind::option, Entity::Kind::option, "(");
    each(model_.behaviors, Completion::Kind::behavior, Entity::Kind::behavior, "(");
    for (std::size_t i = 0; i < model_.symbols.size(); ++i)
      if (model_.symbols[i].kind != SymbolKind::input) symbol(i, " = ");
  }

  void symbol(std::size_t i, const std::string& behind) {
    const Symbol& symbol = model_.symbols[i];
    add(Completion::Kind::symbol, symbol.name, symbol.name + behind,
        signatureOf(project_, {Entity::Kind::symbol, static_cast<int>(i)}), symbol.doc);
  }

  void expression() {
    const Type wanted = expectedType();
    if (wanted.kind == ValueKind::enumeration && wanted.enumeration >= 0) {
      const Enumeration& found = model_.enumerations[at(wanted.enumeration)];
      for (const EnumerationElement& element : found.elements)
        add(Completion::Kind::element, element.name, element.name, "enum " + found.name);
    }
    for (std::size_t i = 0; i < model_.symbols.size(); ++i)
      symbol(i, model_.symbols[i].parameters.empty() ? "" : "(");
    each(model_.constants, Completion::Kind::constant, Entity::Kind::constant);
    optionParameters();
    keywords({"true", "false", "state_time", "option_time", "action_done"});
  }

  bool beginsArgument() const { return context_.back(0).is("(") || context_.back(0).is(","); }

  const std::vector<Parameter>* calledParameters() const {
    const std::size_t callee = context_.callee();
    return callee == 0 ? nullptr : parametersOf(context_.back(callee).text);
  }

  const std::vector<Parameter>* parametersOf(std::string_view name) const {
    return xabsl::server::parametersOf(model_, name).first;
  }

  /// What the left side of the operator before the place is, as far as a name shows it.
  Type expectedType() const {
    const bool assigns = context_.back(0).is("=");
    if (!assigns && !context_.back(0).is("==") && !context_.back(0).is("!=")) return {};
    const Token& left = context_.back(1);
    if (assigns)
      if (const auto* parameters = calledParameters()) return typeOf(*parameters, left.text);
    if (left.kind == TokenKind::parameter)
      for (const Option& option : model_.options)
        if (option.name == context_.optionName()) return typeOf(option.parameters, left.text);
    for (const Symbol& symbol : model_.symbols)
      if (symbol.name == left.text) return symbol.type;
    return {};
  }

  static Type typeOf(const std::vector<Parameter>& parameters, std::string_view name) {
    const int index = indexOf(parameters, name);
    return index < 0 ? Type{} : parameters[at(index)].type;
  }

  const Project& project_;
  const Model& model_;
  const Context& context_;
  std::vector<Completion> result_;
};

}  // namespace

std::vector<Completion> complete(const Project& project, std::string_view text,
                                 std::size_t offset) {
  const Context context(text, offset);
  return Completer(project, context).run();
}

std::optional<Signature> signatureAt(const Project& project, std::string_view text,
                                     std::size_t offset) {
  const Context context(text, offset);
  const std::size_t callee = context.callee();
  if (callee == 0) return std::nullopt;
  const std::string name(context.back(callee).text);
  const auto [parameters, doc] = parametersOf(project.model(), name);
  if (!parameters) return std::nullopt;
  const std::vector<std::string_view> arguments = context.arguments();
  Signature signature{name + "(", doc, {}, static_cast<int>(parameters->size())};
  for (std::size_t i = 0; i < parameters->size(); ++i) {
    const Parameter& parameter = (*parameters)[i];
    const std::string label = describe(project.model(), parameter.type) + " " + parameter.name;
    signature.label += (i > 0 ? ", " : "") + label;
    signature.parameters.push_back({label, parameter.doc});
    // Without a name, that which is not set yet.
    const bool active = arguments.back().empty() ? std::find(arguments.begin(), arguments.end(),
                                                             parameter.name) == arguments.end()
                                                 : arguments.back() == parameter.name;
    if (active) signature.active = std::min(signature.active, static_cast<int>(i));
  }
  signature.label += ")";
  return signature;
}

}  // namespace xabsl::server
