#include "xabsl/formats/intermediate/SymbolsHeader.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <set>
#include <string_view>

#include "xabsl/language/Text.h"

namespace xabsl {

namespace {

constexpr std::array<std::string_view, 87> reserved = {
    "alignas",  "alignof",   "and",       "asm",       "assert",
    "auto",     "bitand",    "bitor",     "bool",      "break",
    "case",     "catch",     "char",      "class",     "compl",
    "concept",  "const",     "consteval", "constexpr", "constinit",
    "continue", "decltype",  "default",   "delete",    "do",
    "double",   "else",      "enum",      "errno",     "explicit",
    "export",   "extern",    "false",     "float",     "for",
    "friend",   "goto",      "if",        "inline",    "int",
    "linux",    "long",      "mutable",   "namespace", "new",
    "noexcept", "not",       "nullptr",   "operator",  "or",
    "private",  "protected", "public",    "register",  "requires",
    "return",   "short",     "signed",    "sizeof",    "static",
    "stderr",   "stdin",     "stdout",    "struct",    "switch",
    "template", "this",      "throw",     "true",      "try",
    "typedef",  "typeid",    "typename",  "union",     "unix",
    "unsigned", "using",     "virtual",   "void",      "volatile",
    "while",    "xor",       "Inputs",    "Outputs",   "BasicBehaviors",
    "In",       "Out"};

char changedCase(char c, bool upper) {
  if (!isLetter(c)) return c;
  return static_cast<char>(upper ? c & ~0x20 : c | 0x20);
}

/// `go_to.ball` as goToBall or GoToBall, `GO_LEFT` as goLeft or GoLeft. Characters that C++ does
/// not allow in names are left out.
std::string cppName(std::string_view name, bool upper) {
  std::string result;
  const bool shouts =
      std::none_of(name.begin(), name.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  bool begins = true;
  for (const char c : name) {
    if (!isLetter(c) && !isDigit(c)) {
      begins = true;
      continue;
    }
    if (result.empty() && isDigit(c)) result += upper ? 'N' : 'n';
    if (result.empty())
      result += changedCase(c, upper);
    else
      result += begins ? changedCase(c, true) : shouts ? changedCase(c, false) : c;
    begins = false;
  }
  if (result.empty()) result = upper ? "Unnamed" : "unnamed";
  if (std::find(reserved.begin(), reserved.end(), result) != reserved.end()) result += '_';
  return result;
}

/// Unique names within a scope.
class Scope {
 public:
  Scope(std::initializer_list<std::string> known = {}) : known_(known) {}

  std::string add(std::string_view name, bool upper = false) {
    const std::string wanted = cppName(name, upper);
    std::string result = wanted;
    // Names with two underscores in a row are reserved.
    const std::string numbered = wanted.back() == '_' ? wanted : wanted + "_";
    for (int i = 2; !known_.insert(result).second; ++i) result = numbered + std::to_string(i);
    return result;
  }

 private:
  std::set<std::string> known_;
};

std::string literal(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// A documentation comment of C++ with the text, range and unit of a declaration.
std::string comment(std::string_view doc, const std::string& range, const std::string& unit,
                    const std::string& indent) {
  std::string text(doc);
  std::string measure = range.empty() ? "" : "[" + range + "]";
  if (!unit.empty()) measure += (measure.empty() ? "" : " ") + unit;
  if (!measure.empty()) text += text.empty() ? "In " + measure : " (" + measure + ")";
  std::string result;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t first = line.find_first_not_of(" \t\r*");
    if (first == std::string_view::npos) continue;
    line.remove_prefix(first);
    // A line that ends with a backslash would go on in the next one.
    line = line.substr(0, line.find_last_not_of(" \t\r\\") + 1);
    result += indent + "/// " + std::string(line) + "\n";
  }
  return result;
}

class HeaderWriter {
 public:
  HeaderWriter(const Model& model, const SymbolsHeaderSettings& settings)
      : model_(model), settings_(settings) {}

  std::string run() {
    text_ +=
        "// Generated from the XABSL behavior by `xabsl header`: changes belong there.\n"
        "#pragma once\n\n#include <concepts>\n#include <tuple>\n\n";
    for (const std::string& include : settings_.includes) text_ += "#include \"" + include + "\"\n";
    text_ += "#include \"xabsl/engine/Symbols.h\"\n\nnamespace " + settings_.space + " {\n\n";
    for (const Enumeration& enumeration : model_.enumerations) declare(enumeration);
    begin("What the behavior asks: a function for each input symbol.", "Inputs");
    for (const Symbol& symbol : model_.symbols)
      if (symbol.kind == SymbolKind::input) declareInput(symbol);
    begin("What the behavior sets: a function for each output symbol.", "Outputs");
    for (const Symbol& symbol : model_.symbols)
      if (symbol.kind == SymbolKind::output) declareOutput(symbol);
    text_ += "};\n\n";
    for (const BasicBehavior& behavior : model_.behaviors) declare(behavior);
    text_ +=
        "/// What the behavior does: an object for each basic behavior.\nstruct BasicBehaviors "
        "{\n" +
        objects_ + "};\n\n" + registration() + "}  // namespace " + settings_.space + "\n";
    return std::move(text_);
  }

 private:
  /// A function's parameters as they are declared, as a lambda takes and as it passes them on, and
  /// their names for the registration.
  struct Parameters {
    std::string declared;
    std::string taken;
    std::string passed;
    std::string names;
  };

  void begin(const char* about, const std::string& name) {
    if (opened_) text_ += "};\n\n";
    opened_ = true;
    scope_ = {};
    text_ += std::string("/// ") + about + "\nclass " + name + " {\n public:\n  virtual ~" + name +
             "() = default;\n";
  }

  void declare(const Enumeration& enumeration) {
    const std::string type = types_.add(enumeration.name, true);
    typeNames_.push_back(type);
    text_ += comment(enumeration.doc, "", "", "");
    const auto bound = settings_.enumerations.find(enumeration.name);
    Scope elements;
    std::string list, registered;
    for (const EnumerationElement& element : enumeration.elements) {
      const std::string name = elements.add(element.name);
      list += (list.empty() ? "" : ", ") + name;
      registered += (registered.empty() ? "{" : ",\n       {") + type + "::" + name + ", " +
                    literal(element.name) + "}";
    }
    if (bound != settings_.enumerations.end())
      text_ += "using " + type + " = " + bound->second + ";\n\n";
    else
      text_ += "enum class " + type + " { " + list + " };\n\n";
    if (settings_.registered.count(enumeration.name) > 0) return;
    registrations_ += "  symbols.enumerationValues<" + type + ">(" + literal(enumeration.name) +
                      ",\n      {" + registered + "});\n";
  }

  std::string typeName(Type type) const {
    if (type.kind == ValueKind::number) return "double";
    return type.kind == ValueKind::boolean ? "bool" : typeNames_[at(type.enumeration)];
  }

  Parameters parameters(const std::vector<Parameter>& list) const {
    Parameters result;
    Scope scope;
    for (const Parameter& parameter : list) {
      const std::string separator = result.names.empty() ? "" : ", ";
      const std::string type = typeName(parameter.type);
      const std::string argument = "p" + std::to_string(&parameter - list.data());
      result.declared += separator + type + " " + scope.add(parameter.name);
      result.taken += separator + type + " " + argument;
      result.passed += separator + argument;
      result.names += separator + literal(parameter.name);
    }
    return result;
  }

  static std::string parameterComment(const std::vector<Parameter>& list) {
    std::string result;
    for (const Parameter& parameter : list) {
      std::string about = comment(parameter.doc, parameter.range, parameter.unit, "  ");
      if (about.empty()) continue;
      result += "  /// `" + parameter.name + "`: " + about.substr(about.find("/// ") + 4);
    }
    return result;
  }

  void declareInput(const Symbol& symbol) {
    const std::string name = scope_.add(symbol.name);
    const Parameters list = parameters(symbol.parameters);
    text_ += "\n" + comment(symbol.doc, symbol.range, symbol.unit, "  ") +
             parameterComment(symbol.parameters) + "  virtual " + typeName(symbol.type) + " " +
             name + "(" + list.declared + ") const = 0;\n";
    registrations_ += "  symbols.input(" + literal(symbol.name) + ", {" + list.names +
                      "}, [&inputs](" + list.taken + ") { return inputs." + name + "(" +
                      list.passed + "); });\n";
  }

  void declareOutput(const Symbol& symbol) {
    const std::string name = scope_.add("set_" + symbol.name), type = typeName(symbol.type);
    text_ += "\n" + comment(symbol.doc, symbol.range, symbol.unit, "  ") + "  virtual void " +
             name + "(" + type + " value) = 0;\n";
    registrations_ += "  symbols.output(" + literal(symbol.name) + ", [&outputs](" + type +
                      " value) { outputs." + name + "(value); });\n";
  }

  /// A class with a member for each parameter.
  void declare(const BasicBehavior& behavior) {
    const std::string type = types_.add(behavior.name, true);
    text_ += comment(behavior.doc, "", "", "") + "class " + type + " {\n public:\n";
    Scope scope({"name", "parameters", "parametersChanged", "execute"});
    std::string list;
    for (const Parameter& parameter : behavior.parameters) {
      const std::string name = scope.add(parameter.name);
      text_ += comment(parameter.doc, parameter.range, parameter.unit, "  ") + "  " +
               typeName(parameter.type) + " " + name + "{};\n";
      list += (list.empty() ? "" : ",\n                      ") + std::string("xabsl::parameter(") +
              literal(parameter.name) + ", &" + type + "::" + name + ")";
    }
    text_ += (list.empty() ? "" : "\n") + std::string("  virtual ~") + type +
             "() = default;\n"
             "  virtual void parametersChanged() {}\n"
             "  virtual void execute() = 0;\n\n"
             "  static constexpr const char* name = " +
             literal(behavior.name) +
             ";\n"
             "  static constexpr auto parameters() {\n    return std::tuple{" +
             list + "};\n  }\n};\n\n";
    const std::string object = objectNames_.add(behavior.name);
    objects_ += "  " + type + "& " + object + ";\n";
    registrations_ += "  symbols.behavior(behaviors." + object + ");\n";
  }

  std::string registration() const {
    return "/// Registers everything above. The objects must outlive the engines that use it; "
           "calls\n"
           "/// of inputs and outputs whose class is `final` are inlined.\n"
           "template <std::derived_from<Inputs> In, std::derived_from<Outputs> Out>\n"
           "void registerSymbols(xabsl::Symbols& symbols, [[maybe_unused]] const In& inputs,\n"
           "                     [[maybe_unused]] Out& outputs,\n"
           "                     [[maybe_unused]] const BasicBehaviors& behaviors) {\n" +
           registrations_ + "}\n\n";
  }

  const Model& model_;
  const SymbolsHeaderSettings& settings_;
  std::string text_;
  std::string registrations_;
  std::vector<std::string> typeNames_;  // of the enumerations
  std::string objects_;                 // of the basic behaviors
  Scope types_;
  Scope scope_;
  Scope objectNames_;
  bool opened_ = false;
};

}  // namespace

std::string writeSymbolsHeader(const Model& model, const SymbolsHeaderSettings& settings) {
  return HeaderWriter(model, settings).run();
}

}  // namespace xabsl
