#include "xabsl/NaiveEngine.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

#include "xabsl/Engine.h"
#include "xabsl/IntermediateCode.h"
#include "xabsl/RandomBehavior.h"
#include "xabsl/TestBehavior.h"

namespace xabsl {
namespace {

/// Any function of its arguments serves.
double called(const Model& model, int symbol, const double* arguments) {
  const Symbol& declared = model.symbols[static_cast<std::size_t>(symbol)];
  double sum = symbol;
  for (std::size_t p = 0; p < declared.parameters.size(); ++p)
    sum += static_cast<double>(p + 2) * arguments[p];
  if (declared.type.kind == ValueKind::number) return sum;
  if (!std::isfinite(sum)) return 0;
  return std::fmod(std::abs(std::trunc(sum)), declared.type.kind == ValueKind::boolean ? 2 : 3);
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

/// Runs both engines side by side in random surroundings.
class Comparison {
 public:
  Comparison(const Behavior& behavior, unsigned seed)
      : model_(behavior.model()),
        call_([this](int symbol, const double* arguments) {
          return called(model_, symbol, arguments);
        }),
        world_(model_, call_),
        engine_(std::move(*Engine::create(behavior, world_.symbols()).engine)),
        naive_(model_, world_, call_),
        random_(seed) {}

  void run(int cycles) {
    for (int i = 0; i < cycles && !testing::Test::HasFailure(); ++i) {
      disturb();
      now_ += static_cast<std::int64_t>(random_() % 50);
      engine_.execute(now_);
      compare(naive_.execute(now_));
    }
  }

  const std::set<std::pair<int, int>>& seen() const { return seen_; }

 private:
  void disturb() {
    for (std::size_t i = 0; i < model_.symbols.size(); ++i) {
      const Symbol& symbol = model_.symbols[i];
      if (symbol.kind != SymbolKind::input || random_() % 3 != 0) continue;
      const int kinds = symbol.type.kind == ValueKind::number    ? 7
                        : symbol.type.kind == ValueKind::boolean ? 2
                                                                 : 3;
      world_.value(static_cast<int>(i)) =
          static_cast<double>(random_() % kinds) - (symbol.type.kind == ValueKind::number ? 3 : 0);
    }
  }

  void compare(const std::vector<test::NaiveEngine::Step>& steps) {
    const std::vector<Activation> activations = engine_.activations();
    ASSERT_EQ(activations.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) compare(activations[i], steps[i]);
    for (std::size_t i = 0; i < model_.symbols.size(); ++i) {
      const Symbol& symbol = model_.symbols[i];
      if (symbol.kind == SymbolKind::input) continue;
      const double expected = naive_.variable(static_cast<int>(i));
      EXPECT_TRUE(same(engine_.symbol(symbol.name)->number, expected)) << symbol.name;
      if (symbol.kind == SymbolKind::output) {
        EXPECT_TRUE(same(world_.value(static_cast<int>(i)), expected)) << symbol.name;
      }
    }
  }

  void compare(const Activation& activation, const test::NaiveEngine::Step& step) {
    const auto index = static_cast<std::size_t>(step.index);
    EXPECT_EQ(activation.name,
              step.option ? model_.options[index].name : model_.behaviors[index].name);
    if (step.option) {
      seen_.insert({step.index, step.state});
      EXPECT_EQ(activation.state, model_.states[static_cast<std::size_t>(step.state)].name);
    }
    EXPECT_EQ(activation.optionTime, step.optionTime);
    EXPECT_EQ(activation.stateTime, step.stateTime);
    ASSERT_EQ(activation.parameters.size(), step.parameters.size());
    for (std::size_t p = 0; p < step.parameters.size(); ++p)
      EXPECT_TRUE(same(activation.parameters[p].number, step.parameters[p]))
          << activation.parameters[p].name;
  }

  const Model& model_;
  VirtualSymbols::Call call_;
  VirtualSymbols world_;
  Engine engine_;
  test::NaiveEngine naive_;
  std::mt19937 random_;
  std::int64_t now_ = 0;
  std::set<std::pair<int, int>> seen_;
};

TEST(NaiveEngine, DoesTheSameAsTheEngineOnRandomBehaviors) {
  std::size_t seen = 0;
  std::size_t states = 0;
  for (unsigned seed = 1; seed <= 200 && !HasFailure(); ++seed) {
    const std::string text = test::RandomBehavior(seed).write();
    SCOPED_TRACE("behavior " + std::to_string(seed) + ":\n" + text);
    const Behavior behavior = test::compiled(text);
    Comparison comparison(behavior, seed);
    comparison.run(300);
    seen += comparison.seen().size();
    states += behavior.model().states.size();
  }
  EXPECT_GT(seen, states / 6);  // so the behaviors do something
}

/// What runs from intermediate code does what runs from the text that it was compiled from.
TEST(NaiveEngine, DoesTheSameFromIntermediateCode) {
  for (unsigned seed = 1; seed <= 20 && !HasFailure(); ++seed) {
    const std::string text = test::RandomBehavior(seed).write();
    SCOPED_TRACE("behavior " + std::to_string(seed) + ":\n" + text);
    const Behavior behavior = test::compiled(text);
    const VirtualSymbols symbols(behavior.model());
    const IntermediateCode code = writeIntermediateCode(behavior.model());
    ASSERT_TRUE(code.text);
    const Compilation read = readIntermediateCode("a.dat", *code.text, &symbols.symbols());
    ASSERT_EQ(test::errors(read.diagnostics), "");
    const auto run = [&](const Behavior& which) {
      Engine engine = std::move(*Engine::create(which, symbols.symbols()).engine);
      std::string log;
      for (int i = 0; i < 100; ++i) {
        engine.execute(i * 7);
        // Intermediate code has no sign: -x becomes 0 - x, and -0 becomes 0.
        for (const Activation& activation : engine.activations())
          for (const NamedValue& parameter : activation.parameters)
            log += activation.state + " " + std::to_string(parameter.number + 0.0) + "\n";
      }
      return log;
    };
    EXPECT_TRUE(run(behavior) == run(*read.behavior));
  }
}

}  // namespace
}  // namespace xabsl
