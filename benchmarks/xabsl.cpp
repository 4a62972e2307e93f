// What a cycle of XABSL's engine costs, and how long a behavior takes from text to running.
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "Parts.h"
#include "xabsl/engine/Engine.h"
#include "xabsl/formats/Compile.h"

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

/// A behavior as people write it: a file for the symbols, and one for each option.
xabsl::VirtualFiles behaviorFiles(const Shape& shape) {
  xabsl::VirtualFiles files;
  std::string symbols = "namespace inputs(\"Inputs\") {\n";
  for (int i = 0; i < inputs; ++i) symbols += "float input input_" + std::to_string(i) + ";\n";
  files["symbols.xabsl"] =
      symbols + "}\nnamespace behaviors(\"Behaviors\") { behavior act { float value; } }\n";
  std::string agents = "include \"symbols.xabsl\";\n";
  for (int layer = 0; layer < shape.layers; ++layer)
    for (int index = 0; index < shape.width; ++index) {
      const std::string name = optionName(layer, index);
      std::string& text = files[name + ".xabsl"] = "option " + name + " {\n";
      for (int s = 0; s < shape.states; ++s) text += state(shape, layer, index, s);
      text += "}\n";
      agents += "include \"" + name + ".xabsl\";\n";
    }
  files["main.xabsl"] = agents + "agent main(\"Main\", " + optionName(0, 0) + ");\n";
  return files;
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

xabsl::Engine started(const xabsl::Compilation& compilation, const World& world) {
  if (!compilation.behavior) throw std::runtime_error("the behavior does not compile");
  auto creation = xabsl::Engine::create(*compilation.behavior, world.symbols);
  if (!creation.engine) throw std::runtime_error("the behavior does not link");
  return std::move(*creation.engine);
}

void cycle(benchmark::State& state, const Shape& shape, bool changing, double atMost) {
  World world;
  xabsl::Engine engine = started(xabsl::compile("main.xabsl", behaviorFiles(shape)), world);
  std::int64_t now = 0;
  for ([[maybe_unused]] auto _ : state) {
    if (changing)
      for (std::size_t i = 0; i < 40; ++i)
        world.values[(i * 5) % inputs] = static_cast<double>((now * 37 + static_cast<int>(i)) % 60);
    engine.execute(++now);
  }
  benchmark::DoNotOptimize(world.acted);
  aim(state, atMost);
}

/// From files on the disk to an engine that has run its first cycle.
void load(benchmark::State& state) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("xabsl-load-" + std::to_string(getpid()));
  fs::create_directories(folder);
  for (const auto& [name, text] : behaviorFiles(network)) std::ofstream{folder / name} << text;
  const World world;
  for ([[maybe_unused]] auto _ : state) {
    xabsl::Engine engine = started(xabsl::compile((folder / "main.xabsl").string()), world);
    engine.execute(0);
    benchmark::DoNotOptimize(engine);
  }
  fs::remove_all(folder);
  aim(state, 20);
}

// Half of what the engine that other teams use needs on such a machine.
BENCHMARK_CAPTURE(cycle, path, path, false, 90)->Name("speed.xabsl.path")->Apply(inNanoseconds);
BENCHMARK_CAPTURE(cycle, path_changing, path, true, 205)
    ->Name("speed.xabsl.path_changing")
    ->Apply(inNanoseconds);
BENCHMARK_CAPTURE(cycle, network, network, false, 265)
    ->Name("speed.xabsl.network")
    ->Apply(inNanoseconds);
BENCHMARK(load)->Name("speed.xabsl.load.wall")->Apply(inMilliseconds)->UseRealTime();
BENCHMARK(load)->Name("speed.xabsl.load.cpu")->Apply(inMilliseconds);

}  // namespace
}  // namespace gt
