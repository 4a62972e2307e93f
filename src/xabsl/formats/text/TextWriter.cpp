#include <algorithm>
#include <optional>
#include <utility>

#include "xabsl/formats/text/Formatter.h"
#include "xabsl/formats/text/SourceWriter.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/language/Operators.h"

namespace xabsl {

using namespace syntax;

namespace {

/// A text for a place between marks: on one line, with the closing mark replaced by another
/// character.
std::string enclosed(std::string_view text, char close) {
  std::string result(text);
  for (char& c : result) {
    if (c == close) c = close == ']' ? ')' : '\'';
    if (c == '\n' || c == '\r') c = ' ';
  }
  return result;
}

class TextWriter {
 public:
  TextWriter(const Program& program, Reporter& reporter)
      : program_(program), reporter_(reporter), comments_(program) {}

  VirtualFiles write(const std::string& root) {
    for (const Collection& collection : collectionsOf(program_)) writeCollection(collection);
    for (const Option& option : program_.options) writeOption(option);
    writeRoot(root);
    checkNames();
    return std::move(files_);
  }

 private:
  // --- Files

  void addFile(Location from, std::string_view name) {
    const std::string path = folderOf(program_, from) + std::string(name) + ".xabsl";
    std::string& text = files_[path];
    if (text.empty()) paths_.push_back(path);
    text += formatted(path);
  }

  /// What was written last, with its lines indented.
  std::string formatted(const std::string& path) {
    const std::string text = std::exchange(text_, {});
    Reporter problems;
    const std::optional<std::string> result =
        format(problems.addFile(path, text), text, problems, CommentLines::keep);
    return result ? *result : text;
  }

  void writeRoot(const std::string& root) {
    const Header& header = program_.header;
    if (!header.title.empty() || !header.platform.empty() || !header.softwareEnvironment.empty())
      text_ += "/***\nTitle: " + enclosed(header.title, '\n') +
               "\nPlatform: " + enclosed(header.platform, '\n') +
               "\nSoftware-Environment: " + enclosed(header.softwareEnvironment, '\n') + "\n*/\n\n";
    for (const std::string& path : paths_) text_ += "include \"" + path + "\";\n";
    text_ += "\n";
    for (const Agent& agent : program_.agents) {
      begin(agent);
      text_ += "agent " + name(agent.name) + "(\"" + enclosed(agent.title, '"') + "\", " +
               name(agent.rootOption) + ");\n\n";
    }
    for (const std::string& comment : comments_.rest()) block(comment);
    std::string text = formatted(root);
    // A namespace may bear the name of the file with the agents.
    std::string& file = files_[root];
    if (!file.empty())
      reporter_.fileError(root, "the file with the agents has the name of another file");
    file = std::move(text);
  }

  void writeCollection(const Collection& collection) {
    const Namespace& space = *collection.space;
    begin(space);
    text_ += "namespace " + name(space.name) + "(\"" + enclosed(space.title, '"') + "\") {\n";
    for (const Collection::Member& member : collection.members) {
      begin(declarationOf(member));
      std::visit([this](const auto* declaration) { declare(*declaration); }, member);
    }
    text_ += "}\n";
    addFile(space.extent.begin, name(space.name));
  }

  // --- Declarations

  void begin(const Declaration& declaration) {
    comments(declaration.extent.begin);
    documentation(declaration.doc);
  }

  void comments(Location place) {
    for (const std::string& comment : comments_.before(place)) block(comment);
  }

  void block(const std::string& comment) { text_ += "/* " + safe(comment) + " */\n"; }

  void documentation(std::string_view doc) {
    if (!doc.empty()) text_ += "/** " + safe(doc) + " */\n";
  }

  static std::string safe(std::string_view comment) {
    std::string text(comment);
    for (std::size_t end = text.find("*/"); end != std::string::npos; end = text.find("*/"))
      text.replace(end, 2, "* /");
    return text;
  }

  void declare(const Enumeration& enumeration) {
    text_ += "enum " + name(enumeration.name) + (enumeration.internal ? " internal" : "") + " { ";
    for (std::size_t i = 0; i < enumeration.elements.size(); ++i)
      text_ += (i > 0 ? ", " : "") + name(enumeration.elements[i]);
    text_ += " };\n";
  }

  void declare(const Symbol& symbol) {
    text_ += type(symbol.type) + wordOf(symbol.kind) + " " + name(symbol.name) +
             details(symbol.range, symbol.unit);
    if (!symbol.parameters.empty()) {
      text_ += " (\n";
      parameters(symbol.parameters, "");
      text_ += ")";
    }
    text_ += ";\n";
  }

  void declare(const Constant& constant) {
    text_ += "float const " + name(constant.name) + " = " + (constant.negative ? "-" : "") +
             std::string(constant.digits) + details(constant.range, constant.unit) + ";\n";
  }

  void declare(const Behavior& behavior) {
    text_ += "behavior " + name(behavior.name) + " {\n";
    parameters(behavior.parameters, "");
    text_ += "}\n";
  }

  void parameters(const std::vector<Parameter>& parameters, const char* mark) {
    for (const Parameter& parameter : parameters) {
      begin(parameter);
      text_ += type(parameter.type) + mark + name(parameter.name) +
               details(parameter.range, parameter.unit) + ";\n";
    }
  }

  std::string type(const TypeName& type) {
    if (type.kind == ValueKind::number) return "float ";
    if (type.kind == ValueKind::boolean) return "bool ";
    return "enum " + name(type.enumeration) + " ";
  }

  static std::string details(std::string_view range, std::string_view unit) {
    return (range.empty() ? "" : " [" + enclosed(range, ']') + "]") +
           (unit.empty() ? "" : " \"" + enclosed(unit, '"') + "\"");
  }

  // --- Options

  void writeOption(const Option& option) {
    begin(option);
    text_ += "option " + name(option.name) + " {\n";
    parameters(option.parameters, "@");
    if (option.commonDecision) {
      text_ += "common decision {\n";
      decision(*option.commonDecision);
      text_ += "}\n";
    }
    if (option.hasCommonActions) {
      text_ += "common action {\n";
      actions(option.commonActions);
      text_ += "}\n";
    }
    for (const State& state : option.states) this->state(state);
    text_ += "}\n";
    addFile(option.extent.begin, name(option.name));
  }

  void state(const State& state) {
    text_ += "\n";
    begin(state);
    text_ += std::string(state.initial ? "initial " : "") + (state.target ? "target " : "") +
             "state " + name(state.name);
    const std::string agents = std::to_string(state.cooperation.agents);
    if (state.cooperation.kind == Cooperation::Kind::capacity) text_ += " capacity " + agents;
    if (state.cooperation.kind == Cooperation::Kind::synchronized)
      text_ += " synchronized " + agents;
    text_ += " {\n";
    if (state.decision) {
      text_ += std::string("decision {\n") + (state.leadingElse ? "else\n" : "");
      decision(*state.decision);
      text_ += "}\n";
    }
    text_ += "action {\n";
    actions(state.actions);
    text_ += "}\n}\n";
  }

  void decision(const Decision& decision) {
    comments(decision.extent.begin);
    if (decision.kind == Decision::Kind::stay) text_ += "stay;\n";
    if (decision.kind == Decision::Kind::go) text_ += "goto " + name(decision.target) + ";\n";
    bool first = true;
    for (const Arm& arm : decision.arms) {
      documentation(arm.doc);
      text_ += first ? "if (" : "else if (";
      first = false;
      expression(*arm.condition, lowest);
      text_ += ") {\n";
      this->decision(*arm.decision);
      text_ += "}\n";
    }
    if (!decision.otherwise) return;
    text_ += "else {\n";
    this->decision(*decision.otherwise);
    text_ += "}\n";
  }

  void actions(const std::vector<Action>& actions) {
    for (const Action& action : actions) {
      comments(action.extent.begin);
      text_ += name(action.name);
      if (action.kind == Action::Kind::assignment) {
        text_ += " = ";
        expression(*action.value, lowest);
      } else {
        const bool ambiguous = program_.dialect == Dialect::xabsl21
                                   ? isAmbiguous(action.name.text)
                                   : action.kind != Action::Kind::call;
        if (ambiguous) text_ += action.kind == Action::Kind::callOption ? " option" : " behavior";
        arguments(action.arguments);
      }
      text_ += ";\n";
    }
  }

  /// True for the name of an option and a basic behavior.
  bool isAmbiguous(std::string_view callee) const {
    const auto named = [&](const Declaration& candidate) { return candidate.name.text == callee; };
    return std::any_of(program_.options.begin(), program_.options.end(), named) &&
           std::any_of(program_.behaviors.begin(), program_.behaviors.end(), named);
  }

  void arguments(const std::vector<Argument>& arguments) {
    text_ += "(";
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (i > 0) text_ += ", ";
      text_ += name(arguments[i].name) + " = ";
      expression(*arguments[i].value, lowest);
    }
    text_ += ")";
  }

  // --- Expressions

  void expression(const Expression& expression, Level wanted) {
    if (expression.kind != Expression::Kind::operation) return leaf(expression);
    const OperatorSpelling operation = spellingOf(expression.operation);
    const bool parentheses = operation.level < wanted;
    if (parentheses) text_ += "(";
    operands(expression, operation);
    if (parentheses) text_ += ")";
  }

  void operands(const Expression& expression, const OperatorSpelling& operation) {
    const auto& operands = expression.operands;
    const Level tighter = static_cast<Level>(operation.level + 1);
    if (operands.size() == 1) {
      text_ += operation.text;
      // Two signs in a row would look like another one.
      return this->expression(*operands[0],
                              expression.operation == Operator::negate ? primary : sign);
    }
    const bool choice = expression.operation == Operator::conditional;
    const bool leftBinds = operation.level >= sum;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (i > 0)
        text_ += choice ? (i == 1 ? " ? " : " : ") : " " + std::string(operation.text) + " ";
      this->expression(*operands[i], choice                ? disjunction
                                     : leftBinds && i == 0 ? operation.level
                                                           : tighter);
    }
  }

  void leaf(const Expression& expression) {
    using Kind = Expression::Kind;
    switch (expression.kind) {
      case Kind::number:
        text_ += expression.name;
        return;
      case Kind::boolean:
        text_ += expression.number != 0 ? "true" : "false";
        return;
      case Kind::parameter:
        text_ += "@" + name({expression.name, expression.location});
        return;
      case Kind::stateTime:
        text_ += "state_time";
        return;
      case Kind::optionTime:
        text_ += "option_time";
        return;
      case Kind::actionDone:
        text_ += "action_done";
        return;
      case Kind::conflict:
        text_ += "conflict";
        return;
      default:
        text_ += name({expression.name, expression.location});
        if (expression.kind == Kind::call) arguments(expression.arguments);
    }
  }

  // --- Names

  /// A name as text allows it.
  std::string name(const Name& source) {
    const auto [known, added] = names_.emplace(source.text, std::string(source.text));
    if (!added) return known->second;
    std::string& written = known->second;
    std::replace(written.begin(), written.end(), '-', '_');
    Reporter ignored;
    if (Lexer(ignored.addFile("", written), written, ignored).next().kind == TokenKind::keyword)
      written += "_";
    if (written != source.text && renamed_.line == 0) renamed_ = source.location;
    places_.emplace(source.text, source.location);
    return written;
  }

  void checkNames() {
    std::map<std::string_view, std::string_view> owners;
    for (const auto& [original, written] : names_) {
      const auto [owner, added] = owners.emplace(written, original);
      if (!added)
        reporter_.error(places_.at(original),
                        inQuotes(original) + " and " + inQuotes(owner->second) +
                            " become the same name in text, " + inQuotes(written));
    }
    if (renamed_.line > 0)
      reporter_.warning(renamed_,
                        "names that text does not allow are written with '_' for '-'; what is "
                        "registered for them must be named so, too");
  }

  const Program& program_;
  Reporter& reporter_;
  LooseComments comments_;
  VirtualFiles files_;
  std::vector<std::string> paths_;  // in the order in which they are to be included
  std::string text_;                // of the present file
  std::map<std::string_view, std::string> names_;
  std::map<std::string_view, Location> places_;
  Location renamed_{0, 0, 0};
};

}  // namespace

VirtualFiles writeText(const Program& program, const std::string& root, Reporter& reporter) {
  return TextWriter(program, reporter).write(root);
}

}  // namespace xabsl
