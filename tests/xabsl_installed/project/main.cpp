#include <xabsl/engine/Engine.h>
#include <xabsl/formats/Compile.h>

#include <iostream>

#include "DoorSymbols.h"  // generated from door.xabsl

struct Door final : door::Inputs, door::Outputs {
  bool visitorWaits = false;

  bool visitor() const override { return visitorWaits; }
  void setLamp(door::Light light) override {
    std::cout << (light == door::Light::green ? '+' : '-');
  }
};

struct Hold final : door::Hold {
  void execute() override { std::cout << (open ? "open" : "closed"); }
};

int main(int, char** argv) {
  Door door;
  Hold hold;
  xabsl::Symbols symbols;
  registerSymbols(symbols, door, door, {hold});

  const xabsl::Compilation compilation = xabsl::compile(argv[1]);
  for (const auto& diagnostic : compilation.diagnostics) std::cerr << toString(diagnostic) << '\n';
  if (!compilation.behavior) return 2;
  auto [engine, diagnostics] = xabsl::Engine::create(*compilation.behavior, symbols);
  for (const auto& diagnostic : diagnostics) std::cerr << toString(diagnostic) << '\n';
  if (!engine) return 2;

  for (int now = 0; now < 4000; now += 1000) {
    door.visitorWaits = now == 1000;
    engine->execute(now);
    std::cout << (now < 3000 ? " " : "\n");
  }
}
