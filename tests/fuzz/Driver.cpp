// Runs a fuzz target where there is no fuzzer: over its corpus, and over the same broken in some
// thousand ways, always the same ones.
#include <algorithm>
#include <cstdio>
#include <string>

#include "Fuzz.h"
#include "base/File.h"
#include "base/Random.h"

namespace {

constexpr int mutations = 500;  // of each file; `make fuzz` looks further

std::string mutated(std::string bytes, gt::Random& random) {
  if (random.chance(0.3)) bytes.resize(random.index(bytes.size() + 1));
  for (std::size_t n = 1 + random.index(8); n > 0 && !bytes.empty(); --n) {
    const std::size_t at = random.index(bytes.size());
    const std::size_t length = random.index(std::min<std::size_t>(bytes.size() - at, 32) + 1);
    if (random.chance(0.2))
      bytes.erase(at, length);
    else if (random.chance(0.2))
      bytes.insert(random.index(bytes.size()), bytes.substr(at, length));
    else
      bytes[at] = static_cast<char>(random.index(256));
  }
  return bytes;
}

void run(const std::string& bytes) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  gt::Random random{1};
  run("");
  for (int i = 1; i < argc; ++i) {
    const auto file = gt::readFile(argv[i]);
    if (!file) {
      std::fprintf(stderr, "%s\n", file.error().text().c_str());
      return 2;
    }
    run(*file);
    for (int n = 0; n < mutations; ++n) run(mutated(*file, random));
  }
  return 0;
}
