#include "Fuzz.h"
#include "MemoryFile.h"
#include "crash/CrashReport.h"
#include "crash/ElfFile.h"

// A crash report, and a program that is said to have crashed.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const auto report = gt::parseCrashReport(gt::textOf(data, size), "fuzz"))
    static_cast<void>(report->callStack());
  const gt::MemoryFile file{data, size};
  if (const auto program = gt::ElfFile::read(file.path()))
    static_cast<void>(program->functionAt(4096));
  return 0;
}
