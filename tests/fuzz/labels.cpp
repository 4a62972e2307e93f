#include <cstdlib>
#include <string>

#include "Fuzz.h"
#include "labels/BallLabels.h"
#include "labels/FieldLabels.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text{gt::textOf(data, size)};
  // What is read is written without loss.
  if (const auto balls = gt::parseLabels(text, "fuzz"))
    if (*gt::parseLabels(gt::labelTable(*balls), "fuzz") != *balls) std::abort();
  if (const auto fields = gt::parseFieldLabels(text, "fuzz"))
    if (*gt::parseFieldLabels(gt::fieldLabelTable(*fields), "fuzz") != *fields) std::abort();
  return 0;
}
