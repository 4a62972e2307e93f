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
  std::uint64_t base = 0;            ///< What was added to the addresses in its file.
  std::uint64_t begin = 0, end = 0;  ///< Where it lay.
  std::string buildId;               ///< In hex; empty if it has none.
  std::string path;
};

/// What a process reported when it crashed; see installCrashHandler(). Provided by
/// parseCrashReport.
struct CrashReport {
  std::string program, signal;
  int signalNumber = 0, code = 0;
  std::uint64_t address = 0;  ///< That was accessed, where the signal is about one.
  std::int64_t sender = 0;    ///< The process that sent the signal; 0 if none did.
  std::int64_t time = 0;      ///< Seconds since 1970.
  std::int64_t process = 0, thread = 0;
  std::vector<std::pair<std::string, std::uint64_t>>
      registers;  ///< Program counter, stack pointer, others.
  std::vector<CrashModule> modules;
  std::string running;  ///< What the thread did that died, such as a process and its module.
  std::vector<std::string> notes;
  std::uint64_t stackBegin = 0;
  std::vector<unsigned char> stack;
  std::vector<std::uint64_t> frames;  ///< The crash first, then return addresses.
  bool complete = false;              ///< Whether the process came to write all of it.

  std::uint64_t programCounter() const { return registers.empty() ? 0 : registers.front().second; }
  /// The module in which an address lies; null if there is none.
  const CrashModule* moduleAt(std::uint64_t address) const;
  /// The call stack: frames, or, if the process could not report them, the crash and what looks
  /// like a return address on the stack.
  std::vector<std::uint64_t> callStack() const;
};

/// Reads a report. What is cut off at the end is left out; errors state the line.
Result<CrashReport> parseCrashReport(std::string_view text, const std::string& file);

}  // namespace gt
