#include "Fuzz.h"
#include "MemoryFile.h"
#include "crash/Symbolizer.h"

// libdw loses a few bytes of memory for each broken file.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libdw";
}

// A crash report, and a program that is said to have crashed.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const auto report = gt::parseCrashReport(gt::textOf(data, size), "fuzz"))
    static_cast<void>(report->callStack());
  const gt::MemoryFile file{data, size};
  gt::CrashReport report;
  report.modules.push_back(
      {.base = 0, .begin = 0, .end = 1 << 20, .buildId = "", .path = file.path()});
  constexpr std::uint64_t inFunction = 0x1c8;  // of corpus/crash/library
  static_cast<void>(gt::Symbolizer{report, {}}.places(inFunction));
  return 0;
}
