#include <cassert>

#include "Fuzz.h"
#include "colors/HsiColors.h"
#include "colors/LabeledImage.h"
#include "colors/TslColors.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = gt::textOf(data, size);
  // What was read is kept by its file. Of TSL classes the order counts, not the numbers.
  if (const auto hsi = gt::parseHsiColors(text, "fuzz"); hsi)
    assert(*gt::parseHsiColors(gt::hsiText(*hsi), "fuzz") == *hsi);
  if (const auto tsl = gt::parseTslColors(text, "fuzz"); tsl)
    assert(gt::parseTslColors(gt::tslText(*tsl), "fuzz")->order() == tsl->order());
  (void)!gt::parseRegions(text, "fuzz");
  return 0;
}
