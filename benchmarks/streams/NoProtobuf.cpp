#include <fmt/core.h>

#include "benchmarks/streams/Streams.h"

void gt::measureStreams(Figures&) {
  fmt::print(stderr, "bench: libprotobuf-dev is not installed; streams are not compared with it\n");
}
