#include "Fuzz.h"
#include "colors/ColorTableFile.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)!gt::parseColorTable(gt::textOf(data, size), "fuzz");
  (void)!gt::parseColorTable(gt::textOf(data, size), "fuzz", gt::nao2009ColorOrder);
  return 0;
}
