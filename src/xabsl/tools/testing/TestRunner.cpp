#include "xabsl/tools/testing/TestRunner.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <utility>

#include "xabsl/engine/Engine.h"
#include "xabsl/engine/VirtualSymbols.h"
#include "xabsl/language/ExpressionAnalyzer.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/tools/testing/Recording.h"
#include "xabsl/tools/trace/Moment.h"
#include "xabsl/tools/trace/Question.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace xabsl {

namespace {

constexpr double mostCycles = 10'000'000;      // of a statement
constexpr double latest = 1e15;                // ms
constexpr std::size_t mostEvents = 5'000'000;  // of a test
constexpr std::size_t mostEventsOfCycle = 1'000'000;

/// The number of units of an angle per radian: angles that are not declared in degrees are in
/// radians.
double perRadian(const std::string& unit) {
  return unit == "deg" ? 180 / std::numbers::pi : 1;
}

/// The value of a mathematical function that all tests provide, by its arguments; empty for other
/// input symbols.
std::optional<double> knownFunction(const Symbol& symbol, const double* arguments) {
  const auto isNumber = [](Type type) { return type.kind == ValueKind::number; };
  const std::vector<Parameter>& parameters = symbol.parameters;
  if (!isNumber(symbol.type) || !std::ranges::all_of(parameters, isNumber, &Parameter::type))
    return std::nullopt;
  if (parameters.size() == 1) {
    const double a = arguments[0], radians = a / perRadian(parameters[0].unit);
    if (symbol.name == "abs") return std::abs(a);
    if (symbol.name == "sqrt") return std::sqrt(std::max(a, 0.));
    if (symbol.name == "sin") return std::sin(radians);
    if (symbol.name == "cos") return std::cos(radians);
  } else if (parameters.size() == 2) {
    if (symbol.name == "min") return std::min(arguments[0], arguments[1]);
    if (symbol.name == "max") return std::max(arguments[0], arguments[1]);
    const int x = findParameter(parameters, "x", symbol.name);
    const int y = findParameter(parameters, "y", symbol.name);
    if (symbol.name == "atan2" && x >= 0 && y >= 0)
      return std::atan2(arguments[y], arguments[x]) * perRadian(symbol.unit);
  }
  return std::nullopt;
}

/// The names of parameters, separated by commas.
std::string listed(const std::vector<Parameter>& parameters) {
  std::string text;
  for (const Parameter& parameter : parameters) text += (text.empty() ? "" : ", ") + parameter.name;
  return text;
}

/// Executes the statements of one test. All statements are prepared first, so that no error occurs
/// late.
class TestRun {
 public:
  TestRun(const Behavior& behavior, const TestFile& file, const BehaviorTest& test)
      : model_(behavior.model()),
        file_(file),
        world_(model_,
               [this](int symbol, const double* arguments) { return call(symbol, arguments); }),
        engine_(std::move(*Engine::create(behavior, world_.symbols()).engine)),
        recorder_(std::min(mostEventsOfCycle, 100'000 + 40 * model_.largestActivation)) {
    result_.name = test.name;
    result_.trace.subject = TraceSubject::of(engine_);
    moment_.emplace(result_.trace.subject);
    for (std::size_t i = 0; i < model_.symbols.size(); ++i)
      if (model_.symbols[i].kind != SymbolKind::input)
        moment_->set(static_cast<int>(i), engine_.symbol(model_.symbols[i].name)->number);
    engine_.record(&recorder_);
    statements_ = file.common;
    statements_.insert(statements_.end(), test.statements.begin(), test.statements.end());
  }
  TestRun(const TestRun&) = delete;
  TestRun& operator=(const TestRun&) = delete;

  TestResult run() {
    std::vector<Prepared> prepared(statements_.size());
    for (std::size_t i = 0; i < statements_.size(); ++i) prepare(statements_[i], prepared[i]);
    for (std::size_t i = 0; i < statements_.size() && good(); ++i)
      execute(statements_[i], prepared[i]);
    return std::move(result_);
  }

 private:
  using Kind = TestStatement::Kind;

  struct Prepared {
    std::shared_ptr<Question> question;
    int symbol = -1;
    std::shared_ptr<std::vector<double>> arguments;  // of a function
    std::shared_ptr<Recording> recording;
  };
  /// An input symbol that an expression drives, or a function.
  struct Driver {
    int symbol;
    std::shared_ptr<Question> question;
    std::shared_ptr<std::vector<double>> arguments;
  };

  bool good() const { return result_.errors.empty() && !result_.failure; }

  Diagnostic diagnostic(Location location, std::string message) const {
    return {Diagnostic::Severity::error, file_.path, location.line, location.column,
            std::move(message)};
  }
  void error(Location location, std::string message) {
    result_.errors.push_back(diagnostic(location, std::move(message)));
  }
  void fail(Location location, std::string message) {
    if (result_.failure) return;
    result_.failure = diagnostic(location, std::move(message));
    const auto& events = result_.trace.events;
    forEachCycle(events, [&](const TraceEvent* first, const TraceEvent* last) {
      if (last == events.data() + events.size())
        result_.moment = printCycle(result_.trace.subject, first, last, true);
    });
  }

  void prepare(const TestStatement& statement, Prepared& prepared) {
    static const Type condition{ValueKind::boolean, -1};
    switch (statement.kind) {
      case Kind::input:
        prepared.symbol = input(statement.name, false);
        if (prepared.symbol >= 0)
          prepared.question = question(statement.expression, typeOf(prepared.symbol));
        break;
      case Kind::function:
        prepareFunction(statement, prepared);
        break;
      case Kind::replay:
        prepareReplay(statement, prepared);
        [[fallthrough]];
      case Kind::run:
      case Kind::until:
      case Kind::expect:
        if (!statement.expression.text.empty())
          prepared.question = question(statement.expression, condition);
        break;
      case Kind::step:
      case Kind::agent:
      case Kind::option:
        break;
    }
  }

  Type typeOf(int symbol) const { return model_.symbols[at(symbol)].type; }

  /// The input symbol of a name, or -1 with an error: one with parameters is defined as a function,
  /// all others get a value.
  int input(const TestText& name, bool function) {
    const int index = model_.findInput(name.text);
    if (index >= 0 && model_.symbols[at(index)].parameters.empty() != function) return index;
    const std::string symbol = "input symbol " + inQuotes(name.text);
    if (index >= 0) {
      const std::string parameters = "(" + listed(model_.symbols[at(index)].parameters) + ")";
      error(name.location, symbol + (function ? " has no parameters" : " has parameters") +
                               ", expected '" + (function ? "" : "function ") +
                               std::string(name.text) + (function ? "" : parameters) + " = ...;'");
    } else if (model_.findOutput(name.text) >= 0) {
      error(name.location,
            inQuotes(name.text) + " is set by the behavior, expected an input symbol");
    } else {
      Suggestion suggestion(name.text);
      for (const Symbol& candidate : model_.symbols)
        if (candidate.kind == SymbolKind::input) suggestion.offer(candidate.name);
      error(name.location, "unknown " + symbol + suggestion.text());
    }
    return -1;
  }

  std::shared_ptr<Question> question(const TestText& text, Type type,
                                     const std::vector<Question::Variable>& variables = {}) {
    Question::Making making =
        Question::make(*moment_, text.text, type, file_.path, text.location, variables);
    for (Diagnostic& wrong : making.diagnostics) result_.errors.push_back(std::move(wrong));
    if (!making.question) return nullptr;
    return std::make_shared<Question>(std::move(*making.question));
  }

  void prepareFunction(const TestStatement& statement, Prepared& prepared) {
    prepared.symbol = input(statement.name, true);
    if (prepared.symbol < 0) return;
    const auto& parameters = model_.symbols[at(prepared.symbol)].parameters;
    prepared.arguments = std::make_shared<std::vector<double>>(parameters.size());
    std::vector<Question::Variable> variables;
    for (const TestText& name : statement.arguments) {
      const int index = findParameter(parameters, name.text, statement.name.text);
      if (index < 0)
        return error(name.location, inQuotes(statement.name.text) + " has no parameter " +
                                        inQuotes(name.text) + ", expected " + listed(parameters));
      const auto place = static_cast<std::size_t>(index);
      variables.push_back(
          {std::string(name.text), parameters[place].type, prepared.arguments->data() + place});
    }
    prepared.question = question(statement.expression, typeOf(prepared.symbol), variables);
  }

  void prepareReplay(const TestStatement& statement, Prepared& prepared) {
    TraceReading reading = loadTraces(besides(file_, statement.name.text));
    for (Diagnostic& wrong : reading.diagnostics) result_.errors.push_back(std::move(wrong));
    if (!reading.traces.empty())
      prepared.recording = std::make_shared<Recording>(std::move(reading.traces), model_);
  }

  void execute(const TestStatement& statement, const Prepared& prepared) {
    switch (statement.kind) {
      case Kind::step:
        step_ = statement.time;
        break;
      case Kind::agent:
        if (!engine_.selectAgent(statement.name.text))
          error(statement.name.location,
                "there is no agent '" + std::string(statement.name.text) + "'");
        break;
      case Kind::option:
        selectRoot(statement);
        break;
      case Kind::function:
      case Kind::input:
        std::erase_if(drivers_,
                      [&](const Driver& driver) { return driver.symbol == prepared.symbol; });
        drivers_.push_back({prepared.symbol, prepared.question, prepared.arguments});
        break;
      case Kind::run:
        run(statement, prepared);
        break;
      case Kind::until:
        runUntil(statement, prepared);
        break;
      case Kind::expect:
        expect(statement, prepared);
        break;
      case Kind::replay:
        replay(statement, prepared);
        break;
    }
  }

  void selectRoot(const TestStatement& statement) {
    const std::string_view name = statement.name.text;
    if (!engine_.selectRootOption(name) && !engine_.selectBehavior(name))
      error(statement.name.location,
            "there is no option or basic behavior '" + std::string(name) + "'");
    for (std::size_t i = 0; i < statement.arguments.size() && good(); ++i)
      if (!engine_.setParameter(statement.arguments[i].text, statement.values[i].text))
        error(statement.arguments[i].location,
              "there is no parameter '" + std::string(statement.arguments[i].text) +
                  "', or it cannot be " + std::string(statement.values[i].text));
  }

  double cycles(double ms) const { return std::min(std::floor(ms / step_), mostCycles); }

  void run(const TestStatement& statement, const Prepared& prepared) {
    const double count = std::max(cycles(statement.time), 1.0);
    for (double i = 0; i < count && good(); ++i) {
      cycle();
      if (prepared.question) demand(statement.expression, *prepared.question, "does not hold: ");
    }
  }

  void runUntil(const TestStatement& statement, const Prepared& prepared) {
    const double count = std::max(cycles(statement.time), 1.0);
    for (double i = 0; i < count && good(); ++i) {
      cycle();
      if (prepared.question->answer().value_or(0) != 0) return;
    }
    if (good())
      fail(statement.expression.location,
           "did not come true within time: " + std::string(statement.expression.text));
  }

  void expect(const TestStatement& statement, const Prepared& prepared) {
    demand(statement.expression, *prepared.question, "does not hold: ");
  }

  void demand(const TestText& expression, Question& question, const char* otherwise) {
    const std::optional<double> answer = question.answer();
    if (!answer)
      fail(expression.location,
           "asks for a symbol that was neither read nor set: " + std::string(expression.text));
    else if (*answer == 0)
      fail(expression.location, otherwise + std::string(expression.text));
  }

  void replay(const TestStatement& statement, const Prepared& prepared) {
    recording_ = prepared.recording;
    recording_->restart();
    bool any = false;
    while (good() && recording_->nextCycle()) {
      if (recording_->time() < statement.time || recording_->time() > statement.to) continue;
      cycle(any ? recording_->time() - recording_->previousTime() : step_);
      any = true;
      if (prepared.question) demand(statement.expression, *prepared.question, "does not hold: ");
    }
    recording_.reset();
    if (!any && good()) error(statement.location, "the trace has no cycle of that time");
  }

  void cycle() { cycle(step_); }

  void cycle(double ms) {
    // A recorded time may be any number.
    now_ = started_ && now_ + ms < latest && now_ + ms > -latest ? now_ + ms : now_;
    started_ = true;
    if (recording_)
      for (const auto& [symbol, value] : recording_->inputs()) set(symbol, value);
    for (const Driver& driver : drivers_)
      if (!driver.arguments)
        if (const std::optional<double> value = driver.question->answer())
          set(driver.symbol, *value);
    engine_.execute(static_cast<std::int64_t>(now_));
    const std::vector<TraceEvent> events = recorder_.events();
    recorder_.clear();
    moment_->take(events.data(), events.data() + events.size());
    result_.trace.events.insert(result_.trace.events.end(), events.begin(), events.end());
    if (result_.trace.events.size() > mostEvents)
      error(file_.behavior.location, "test '" + result_.name + "' runs for too many cycles");
  }

  void set(int symbol, double value) {
    world_.value(symbol) = value;
    moment_->set(symbol, value);
  }

  /// An input symbol with parameters: as defined, else as known, else as recorded.
  double call(int symbol, const double* arguments) {
    for (const Driver& driver : drivers_) {
      if (driver.symbol != symbol) continue;
      std::copy_n(arguments, driver.arguments->size(), driver.arguments->begin());
      return driver.question->answer().value_or(0);
    }
    const Symbol& called = model_.symbols[at(symbol)];
    if (const auto known = knownFunction(called, arguments)) return *known;
    if (recording_) return recording_->call(symbol, arguments);
    if (result_.errors.empty())
      error(file_.behavior.location, "the behavior calls '" + called.name +
                                         "', which needs a definition: function " + called.name +
                                         "(" + listed(called.parameters) + ") = ...;");
    return 0;
  }

  const Model& model_;
  const TestFile& file_;
  VirtualSymbols world_;
  Engine engine_;
  TraceRecorder recorder_;
  TestResult result_;
  std::optional<Moment> moment_;
  std::vector<TestStatement> statements_;
  std::vector<Driver> drivers_;
  std::shared_ptr<Recording> recording_;
  double step_ = 40;
  double now_ = 0;
  bool started_ = false;
};

}  // namespace

TestResult runTest(const Behavior& behavior, const TestFile& file, const BehaviorTest& test) {
  return TestRun(behavior, file, test).run();
}

std::string besides(const TestFile& file, std::string_view path) {
  return (std::filesystem::path(file.path).parent_path() / std::filesystem::path(path))
      .lexically_normal()
      .generic_string();
}

}  // namespace xabsl
