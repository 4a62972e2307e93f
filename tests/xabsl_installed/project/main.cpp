#include <xabsl/Engine.h>

#include <iostream>

int main(int, char** argv) {
  bool visitor = false;
  xabsl::Symbols symbols;
  symbols.input("visitor", &visitor);
  symbols.behavior("hold", {"open"}, [](bool open) { std::cout << (open ? "open" : "closed"); });

  const xabsl::Compilation compilation = xabsl::compile(argv[1]);
  for (const auto& diagnostic : compilation.diagnostics) std::cerr << toString(diagnostic) << '\n';
  if (!compilation.behavior) return 2;
  auto [engine, diagnostics] = xabsl::Engine::create(*compilation.behavior, symbols);
  for (const auto& diagnostic : diagnostics) std::cerr << toString(diagnostic) << '\n';
  if (!engine) return 2;

  for (int now = 0; now < 4000; now += 1000) {
    visitor = now == 1000;
    engine->execute(now);
    std::cout << (now < 3000 ? " " : "\n");
  }
}
