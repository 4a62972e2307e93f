#include "xabsl/tests/NaiveEngine.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

#include "xabsl/engine/Engine.h"
#include "xabsl/formats/intermediate/IntermediateCode.h"
#include "xabsl/tests/RandomBehavior.h"
#include "xabsl/tests/TestBehavior.h"

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

/// A robot with both engines.
struct Robot {
  Robot(const Behavior& behavior, double priority, int ticks)
      : model(behavior.model()),
        call([this](int symbol, const double* arguments) {
          return called(model, symbol, arguments);
        }),
        world(model, call),
        engine(std::move(*Engine::create(behavior, world.symbols()).engine)),
        naive(model, world, call, priority, ticks) {
    engine.cooperation().configure(priority, ticks);
  }

  const Model& model;
  VirtualSymbols::Call call;
  VirtualSymbols world;
  Engine engine;
  test::NaiveEngine naive;
  TraceRecorder recorder{10'000};
};

/// Runs both engines side by side, in random surroundings and in a team whose robots hear one
/// another a cycle later.
class Comparison {
 public:
  Comparison(const Behavior& behavior, unsigned seed) : model_(behavior.model()), random_(seed) {
    const int ticks = static_cast<int>(seed % 4);
    for (int i = 0; i < 3; ++i) robots_.push_back(std::make_unique<Robot>(behavior, i, ticks));
  }

  void run(int cycles) {
    for (int i = 0; i < cycles && !testing::Test::HasFailure(); ++i) {
      now_ += static_cast<std::int64_t>(random_() % 50);
      talk();
      for (auto& robot : robots_) {
        disturb(robot->world);
        const bool records = random_() % 2 == 0;
        robot->recorder.clear();
        robot->engine.record(records ? &robot->recorder : nullptr);
        robot->engine.execute(now_);
        compare(*robot, robot->naive.execute(now_, heard_[robot.get()]));
        if (records) compare(robot->recorder.events(), robot->naive.events());
      }
    }
  }

  const std::set<std::pair<int, int>>& seen() const { return seen_; }

 private:
  /// Each hears the others.
  void talk() {
    for (auto& robot : robots_) {
      std::vector<CooperationMessage> messages;
      heard_[robot.get()].clear();
      for (auto& other : robots_)
        if (other != robot) {
          messages.push_back(other->engine.cooperation().message());
          heard_[robot.get()].push_back(other->naive.message());
        }
      robot->engine.cooperation().receive(messages);
    }
  }

  void disturb(VirtualSymbols& world) {
    for (std::size_t i = 0; i < model_.symbols.size(); ++i) {
      const Symbol& symbol = model_.symbols[i];
      if (symbol.kind != SymbolKind::input || random_() % 3 != 0) continue;
      const int kinds = symbol.type.kind == ValueKind::number    ? 7
                        : symbol.type.kind == ValueKind::boolean ? 2
                                                                 : 3;
      world.value(static_cast<int>(i)) =
          static_cast<double>(random_() % kinds) - (symbol.type.kind == ValueKind::number ? 3 : 0);
    }
  }

  void compare(Robot& robot, const std::vector<test::NaiveEngine::Step>& steps) {
    const std::vector<Activation> activations = robot.engine.activations();
    ASSERT_EQ(activations.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) compare(activations[i], steps[i]);
    for (std::size_t i = 0; i < model_.symbols.size(); ++i) {
      const Symbol& symbol = model_.symbols[i];
      if (symbol.kind == SymbolKind::input) continue;
      const double expected = robot.naive.variable(static_cast<int>(i));
      EXPECT_TRUE(same(robot.engine.symbol(symbol.name)->number, expected)) << symbol.name;
      if (symbol.kind == SymbolKind::output) {
        EXPECT_TRUE(same(robot.world.value(static_cast<int>(i)), expected)) << symbol.name;
      }
    }
  }

  void compare(const std::vector<TraceEvent>& actual, const std::vector<TraceEvent>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      ASSERT_EQ(actual[i].kind, expected[i].kind) << i;
      EXPECT_EQ(actual[i].index, expected[i].index) << i;
      EXPECT_TRUE(same(actual[i].value, expected[i].value)) << i;
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
  std::vector<std::unique_ptr<Robot>> robots_;
  std::map<const Robot*, std::vector<test::NaiveEngine::Message>> heard_;
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
    comparison.run(100);
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
