#include "Fuzz.h"
#include "MemoryFile.h"
#include "simulation/scene/ModelFile.h"
#include "simulation/scene/ModelNames.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const gt::MemoryFile file{data, size};
  std::vector<gt::Error> errors;
  if (const auto model = gt::ModelFile::read(file.path(), errors))
    gt::prefixNames(model->root(), {"red1/", "robot/"}, false);
  return 0;
}
