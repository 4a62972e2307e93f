#include "images/Jpeg.h"

#include "Fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  (void)!gt::decodeJpeg({data, size});
  return 0;
}
