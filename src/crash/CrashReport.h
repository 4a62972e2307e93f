#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/Result.h"

namespace gt {

/// A program or library that was loaded.
struct CrashModule {
  std::uint64_t base = 0;            ///< Offset that was added to the addresses in its file.
  std::uint64_t begin = 0, end = 0;  ///< Its range of addresses.
  std::string buildId;               ///< In hex; empty if it has none.
  std::string path;
};

/// The report of a process about its crash; see installCrashHandler(). Provided by
/// parseCrashReport.
struct CrashReport {
  std::string program, signal;
  int signalNumber = 0, code = 0;
  std::uint64_t address = 0;  ///< Accessed address, for signals that concern one.
  std::int64_t sender = 0;    ///< The process that sent the signal; 0 if none did.
  std::int64_t time = 0;      ///< Seconds since 1970.
  std::int64_t process = 0, thread = 0;
  std::vector<std::pair<std::string, std::uint64_t>>
      registers;  ///< Program counter, stack pointer, others.
  std::vector<CrashModule> modules;
  std::string running;  ///< Work of the crashed thread, such as a process and its module.
  std::vector<std::string> notes;
  std::uint64_t stackBegin = 0;
  std::vector<unsigned char> stack;
  std::vector<std::uint64_t> frames;  ///< The crash first, then return addresses.
  bool complete = false;              ///< Whether the process completed the report.

  std::uint64_t programCounter() const { return registers.empty() ? 0 : registers.front().second; }
  /// The module in which an address lies; null if there is none.
  const CrashModule* moduleAt(std::uint64_t address) const;
  /// The call stack: the frames or, if the process could not report them, the address of the crash
  /// and all values on the stack that look like return addresses.
  std::vector<std::uint64_t> callStack() const;
};

/// Parses a report. An incomplete end is ignored; errors state the line.
Result<CrashReport> parseCrashReport(std::string_view text, const std::string& file);

}  // namespace gt
