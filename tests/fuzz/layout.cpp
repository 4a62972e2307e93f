#include "framework/Layout.h"

#include "Fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto layout = gt::parseLayout(gt::textOf(data, size), "fuzz");
  if (layout) (void)!gt::makePlan(*layout, gt::SolutionTable{}, {}, {});
  return 0;
}
