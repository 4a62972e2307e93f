#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl::test {

enum class Mode { slow, fast, turbo };

/// A small world for all behaviors of these tests: three inputs, three outputs, two basic
/// behaviors.
struct World {
  double x = 0;
  double y = 0;
  bool seen = false;
  Mode mode = Mode::slow;
  double result = -1;
  bool flag = false;
  Mode request = Mode::slow;
  std::vector<std::string> log;
  int reads = 0;
  int changes = 0;
  Symbols symbols;

  World() {
    symbols.enumeration<Mode>("mode", {"slow", "fast", "turbo"});
    symbols.input("x", &x);
    symbols.input("y", [this] {
      ++reads;
      return y;
    });
    symbols.input("seen", &seen);
    symbols.input("drive_mode", &mode);
    symbols.input("weighted", {"b", "a"}, [](double b, double a) { return 10 * a + b; });
    symbols.output("result", [this](double value) {
      result = value;
      log.push_back("result " + std::to_string(static_cast<int>(value)));
    });
    symbols.output("flag", &flag);
    symbols.output("request", [this](Mode value) { request = value; });
    symbols.behavior(
        "walk", {"speed", "careful", "style"},
        [this](double speed, bool careful, Mode style) {
          log.push_back("walk " + std::to_string(static_cast<int>(speed)) +
                        (careful ? " careful " : " bold ") +
                        std::to_string(static_cast<int>(style)));
        },
        [this] { ++changes; });
    symbols.behavior("stop", [this] { log.push_back("stop"); });
  }
};

inline const std::string declarations = R"(
  namespace main("Symbols") {
    enum mode { fast, slow };
    enum step { first, second, third };
    float input x;
    float input y [0..10] "mm";
    bool input seen;
    enum mode input drive_mode;
    float input weighted (float a; float b;);
    float output result;
    bool output flag;
    enum mode output request;
    float internal memory;
    bool internal was_seen;
    enum step internal current;
    float const limit = -2.5 "mm";
  }
  namespace main("Behaviors") {
    behavior walk { float speed [0..500] "mm/s"; bool careful; enum mode style; }
    behavior stop { }
  }
  agent main("Main", main);
)";

/// Runs the option `main` and the options declared with it.
class EngineTest : public testing::Test {
 protected:
  void load(const std::string& options) {
    Engine::Creation creation = Engine::create(compiled(declarations + options), world.symbols);
    ASSERT_EQ(errors(creation.diagnostics), "");
    engine.emplace(std::move(*creation.engine));
  }

  /// `option/state` and `behavior` of the last cycle.
  std::vector<std::string> path() const {
    std::vector<std::string> path;
    for (const Activation& activation : engine->activations())
      path.push_back(activation.name + (activation.state.empty() ? "" : "/" + activation.state));
    return path;
  }

  std::vector<std::string> pathAt(std::int64_t now) {
    engine->execute(now);
    return path();
  }

  /// The value of an expression of type float.
  double value(const std::string& expression) {
    load("option main { initial state s { action { result = " + expression + "; } } }");
    engine->execute(0);
    return world.result;
  }

  /// The value of a condition.
  bool holds(const std::string& condition) { return value(condition + " ? 1 : 0") != 0; }

  World world;
  std::optional<Engine> engine;
};

}  // namespace xabsl::test
