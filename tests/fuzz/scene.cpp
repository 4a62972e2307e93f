#include "simulation/scene/Scene.h"

#include "Fuzz.h"
#include "MemoryFile.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const gt::MemoryFile file{data, size};
  (void)!gt::loadScene(file.path());
  return 0;
}
