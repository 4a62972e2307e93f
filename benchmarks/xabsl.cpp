// What a cycle of XABSL's engine costs, and how long a behavior takes from text to running.
#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include "Parts.h"
#include "xabsl/Engine.h"

namespace gt {
namespace {

constexpr int inputs = 200;

/// Layers of options; in each cycle one of each layer is active, and below them a basic behavior.
struct Shape {
  int layers;
  int width;       // options in a layer
  int states;      // of an option
  int conditions;  // that a state asks before it stays
};

constexpr Shape path{5, 1, 2, 4};       // five options, 20 conditions a cycle
constexpr Shape network{10, 10, 4, 2};  // 100 options, 400 states, 11 active at once

std::string optionName(int layer, int index) {
  return "option_" + std::to_string(layer) + "_" + std::to_string(index);
}

std::string state(const Shape& shape, int layer, int index, int number) {
  std::string text = number == 0 ? "initial state s" : "state s";
  text += std::to_string(number) + " { decision { ";
  const int first = (layer * shape.width + index) * shape.states + number;
  for (int c = 0; c < shape.conditions; ++c)
    text += "if (input_" + std::to_string((first * 7 + c * 13) % inputs) + " > " +
            std::to_string(50 + c) + ") goto s" + std::to_string((number + 1) % shape.states) +
            "; else ";
  text += "stay; } action { ";
  text += layer + 1 < shape.layers
              ? optionName(layer + 1, (index * 3 + number) % shape.width) + "();"
              : "act(value = state_time);";
  return text + " } }\n";
}

std::string behaviorText(const Shape& shape) {
  std::string text = "namespace inputs(\"Inputs\") {\n";
  for (int i = 0; i < inputs; ++i) text += "float input input_" + std::to_string(i) + ";\n";
  text += "}\nnamespace behaviors(\"Behaviors\") { behavior act { float value; } }\n";
  for (int layer = 0; layer < shape.layers; ++layer)
    for (int index = 0; index < shape.width; ++index) {
      text += "option " + optionName(layer, index) + " {\n";
      for (int s = 0; s < shape.states; ++s) text += state(shape, layer, index, s);
      text += "}\n";
    }
  return text + "agent main(\"Main\", " + optionName(0, 0) + ");\n";
}

/// The surroundings of a behavior.
struct World {
  std::array<double, inputs> values{};
  double acted = 0;
  xabsl::Symbols symbols;

  World() {
    for (int i = 0; i < inputs; ++i)
      symbols.input("input_" + std::to_string(i), &values[static_cast<std::size_t>(i)]);
    symbols.behavior("act", {"value"}, [this](double value) { acted += value; });
  }
};

xabsl::Engine started(const std::string& text, const World& world) {
  const xabsl::Compilation compilation = xabsl::compile("main.xabsl", {{"main.xabsl", text}});
  if (!compilation.behavior) throw std::runtime_error("the behavior does not compile");
  auto creation = xabsl::Engine::create(*compilation.behavior, world.symbols);
  if (!creation.engine) throw std::runtime_error("the behavior does not link");
  return std::move(*creation.engine);
}

void cycle(benchmark::State& state, const Shape& shape, bool changing) {
  World world;
  xabsl::Engine engine = started(behaviorText(shape), world);
  std::int64_t now = 0;
  for ([[maybe_unused]] auto _ : state) {
    if (changing)
      for (std::size_t i = 0; i < 40; ++i)
        world.values[(i * 5) % inputs] = static_cast<double>((now * 37 + static_cast<int>(i)) % 60);
    engine.execute(++now);
  }
  benchmark::DoNotOptimize(world.acted);
}

void compileNetwork(benchmark::State& state) {
  const World world;
  const std::string text = behaviorText(network);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(started(text, world));
}

BENCHMARK_CAPTURE(cycle, path, path, false)->Name("speed.xabsl.path")->Apply(inNanoseconds);
BENCHMARK_CAPTURE(cycle, path_changing, path, true)
    ->Name("speed.xabsl.path_changing")
    ->Apply(inNanoseconds);
BENCHMARK_CAPTURE(cycle, network, network, false)
    ->Name("speed.xabsl.network")
    ->Apply(inNanoseconds);
BENCHMARK(compileNetwork)->Name("speed.xabsl.load")->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
