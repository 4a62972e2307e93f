#include "console/Condition.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/Number.h"

namespace gt {

/// Parses a condition.
class ConditionParser {
 public:
  explicit ConditionParser(std::string_view text) : text_{text} { next(); }

  Result<Condition> parse() {
    condition_.root_ = read();
    if (error_.empty() && !token_.empty()) fail("is not expected here");
    if (!error_.empty()) return Error{.field = field_, .what = error_};
    return std::move(condition_);
  }

 private:
  using Operator = Condition::Operator;
  static constexpr int deepest = 60;
  static constexpr std::size_t mostNodes = 500;

  int fail(const std::string& what) {
    if (error_.empty()) {
      field_ = token_.empty() ? "the condition's end" : token_;
      error_ = what;
    }
    token_.clear();
    at_ = text_.size();
    return 0;
  }
  int add(Operator operation, int a = -1, int b = -1) {
    if (condition_.nodes_.size() >= mostNodes)
      return fail("comes too late: the condition is too long");
    condition_.nodes_.push_back({operation, a, b});
    return static_cast<int>(condition_.nodes_.size()) - 1;
  }

  void next() {
    at_ = std::min(text_.find_first_not_of(" \t\r", at_), text_.size());
    const std::size_t begin = at_;
    if (at_ == text_.size()) {
      token_.clear();
      return;
    }
    const auto inWord = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
    };
    if (inWord(text_[at_]))
      while (at_ < text_.size() && inWord(text_[at_])) ++at_;
    else
      at_ += isPair() ? 2 : 1;
    token_ = text_.substr(begin, at_ - begin);
  }
  bool isPair() const {
    const std::string_view pair = text_.substr(at_, 2);
    return pair == "<=" || pair == ">=" || pair == "==" || pair == "!=" || pair == "&&" ||
           pair == "||";
  }
  bool take(std::string_view token) {
    if (token_ != token) return false;
    next();
    return true;
  }

  /// The binary operators, by their precedence.
  struct Binary {
    std::string_view token;
    Operator operation;
    int level;
  };
  static constexpr int negation = 2, comparison = 3, sum = 4, product = 5;
  static constexpr Binary binaries[] = {
      {"or", Operator::orElse, 0},           {"||", Operator::orElse, 0},
      {"and", Operator::andAlso, 1},         {"&&", Operator::andAlso, 1},
      {"<", Operator::less, comparison},     {"<=", Operator::lessOrEqual, comparison},
      {">", Operator::greater, comparison},  {">=", Operator::greaterOrEqual, comparison},
      {"==", Operator::equal, comparison},   {"=", Operator::equal, comparison},
      {"!=", Operator::unequal, comparison}, {"+", Operator::plus, sum},
      {"-", Operator::minus, sum},           {"*", Operator::times, product},
      {"/", Operator::divide, product}};

  /// Parses an expression of operators of a level or of higher precedence, which associate to the
  /// left; comparisons cannot be chained.
  int read(int level = 0) {
    if (level > product) return readFactor();
    if (level == negation) return readNot();
    int left = read(level + 1);
    for (;;) {
      const auto* found = std::ranges::find_if(binaries, [&](const Binary& binary) {
        return binary.level == level && binary.token == token_;
      });
      if (found == std::end(binaries)) return left;
      next();
      const int right = read(level + 1);
      left = add(found->operation, left, right);
      if (level == comparison) return left;
    }
  }
  int readNot() {
    if (!take("not") && !take("!")) return read(comparison);
    if (++depth_ > deepest) return fail("is nested too deeply");
    const int operand = readNot();
    --depth_;
    return add(Operator::no, operand);
  }
  int readFactor() {
    if (++depth_ > deepest) return fail("is nested too deeply");
    const int node = readOperand();
    --depth_;
    return node;
  }
  int readOperand() {
    if (take("-")) return add(Operator::negate, readFactor());
    if (take("(")) {
      const int inner = read();
      return take(")") ? inner : fail("expected )");
    }
    if (token_.empty()) return fail("expected a value");
    const std::string token = token_;
    if (std::isdigit(static_cast<unsigned char>(token[0])) || token[0] == '.') return readNumber();
    if (!std::isalpha(static_cast<unsigned char>(token[0])) && token[0] != '_')
      return fail("expected a value");
    next();
    if (token_ == "(") return readCall(token);
    const int node = add(Operator::name);
    condition_.nodes_.back().text = token;
    return node;
  }
  int readNumber() {
    const auto number = numberFrom<double>(token_);
    if (!number) return fail("is no number");
    next();
    const int node = add(Operator::number);
    condition_.nodes_.back().number = *number;
    return node;
  }
  int readCall(const std::string& function) {
    static const std::map<std::string_view, Operator> functions{{"abs", Operator::abs},
                                                                {"min", Operator::min},
                                                                {"max", Operator::max},
                                                                {"distance", Operator::distance}};
    const auto known = functions.find(function);
    if (known == functions.end()) return fail("follows " + function + ", which is no function");
    next();
    const int a = read(sum);
    int b = -1;
    if (known->second != Operator::abs) {
      if (!take(",")) return fail("expected ,");
      b = read(sum);
    }
    if (!take(")")) return fail("expected )");
    return add(known->second, a, b);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string token_;
  int depth_ = 0;
  Condition condition_;
  std::string field_, error_;
};

/// Evaluates a condition's nodes; the first error is kept.
class ConditionValues {
 public:
  ConditionValues(const Condition& condition, Console& console)
      : nodes_{condition.nodes_}, console_{console} {}

  bool truth(int index) {
    const Condition::Node& node = at(index);
    switch (node.operation) {
      case Operator::orElse:
        return truth(node.a) || truth(node.b);
      case Operator::andAlso:
        return truth(node.a) && truth(node.b);
      case Operator::no:
        return !truth(node.a);
      case Operator::equal:
        return equal(node);
      case Operator::unequal:
        return !equal(node);
      case Operator::less:
        return number(node.a) < number(node.b);
      case Operator::lessOrEqual:
        return number(node.a) <= number(node.b);
      case Operator::greater:
        return number(node.a) > number(node.b);
      case Operator::greaterOrEqual:
        return number(node.a) >= number(node.b);
      default:
        return number(index) != 0;
    }
  }
  const std::optional<Error>& error() const { return error_; }

 private:
  using Operator = Condition::Operator;

  const Condition::Node& at(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
  double fail(const Error& error) {
    if (!error_) error_ = error;
    return 0;
  }
  double number(int index) {
    const Condition::Node& node = at(index);
    switch (node.operation) {
      case Operator::number:
        return node.number;
      case Operator::name:
        return named(node.text);
      case Operator::plus:
        return number(node.a) + number(node.b);
      case Operator::minus:
        return number(node.a) - number(node.b);
      case Operator::times:
        return number(node.a) * number(node.b);
      case Operator::divide:
        return number(node.a) / number(node.b);
      case Operator::negate:
        return -number(node.a);
      case Operator::abs:
        return std::abs(number(node.a));
      case Operator::min:
        return std::min(number(node.a), number(node.b));
      case Operator::max:
        return std::max(number(node.a), number(node.b));
      case Operator::distance:
        return (place(node.a) - place(node.b)).norm();
      default:
        return truth(index);
    }
  }
  double named(const std::string& name) {
    if (name == "true" || name == "false") return name == "true";
    const auto value = valueAt(console_, name);
    if (!value) return fail(value.error());
    if (!value->number) return fail({.field = name, .what = "is no number but " + value->text});
    return *value->number;
  }
  Vector2d place(int index) {
    const auto found = placeOf(console_, at(index).text);
    if (!found) fail({.field = at(index).text, .what = "is no robot or ball of the scene"});
    return found.value_or(Vector2d::Zero());
  }
  /// The text of a value, or the name itself if it is no value, such as playing.
  std::optional<std::string> text(int index) {
    const Condition::Node& node = at(index);
    if (node.operation != Operator::name) return std::nullopt;
    const auto value = valueAt(console_, node.text);
    if (value) return value->number ? std::nullopt : std::optional{value->text};
    return node.text == "true" || node.text == "false" ? std::nullopt : std::optional{node.text};
  }
  /// Numbers are compared with numbers, names with names; one side at least must be a value.
  bool equal(const Condition::Node& node) {
    const auto a = text(node.a), b = text(node.b);
    if (!a && !b) return number(node.a) == number(node.b);
    if (!a || !b) {
      const int name = a ? node.a : node.b;
      fail(valueAt(console_, at(name).text) ? Error{.field = at(name).text, .what = "is no number"}
                                            : valueAt(console_, at(name).text).error());
      return false;
    }
    if (!valueAt(console_, at(node.a).text) && !valueAt(console_, at(node.b).text))
      fail({.field = *a, .what = "there is no such value; try get ?"});
    return *a == *b;
  }

  const std::vector<Condition::Node>& nodes_;
  Console& console_;
  std::optional<Error> error_;
};

Result<Condition> Condition::parse(std::string_view text) {
  return ConditionParser{text}.parse();
}

Result<bool> Condition::holds(Console& console) const {
  ConditionValues values{*this, console};
  const bool truth = values.truth(root_);
  if (values.error()) return *values.error();
  return truth;
}

}  // namespace gt
