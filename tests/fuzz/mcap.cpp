#include "streams/mcap/Mcap.h"

#include "Fuzz.h"
#include "MemoryFile.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const gt::MemoryFile file{data, size};
  auto reader = gt::McapReader::open(file.path());
  if (!reader) return 0;
  const auto readAll = [&] {
    // Each call moves on by at least one byte.
    for (std::size_t i = 0; i <= 16 * size && reader->next(); ++i) {
    }
  };
  readAll();
  reader->seek(1000);
  readAll();
  return 0;
}
