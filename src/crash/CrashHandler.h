#pragma once
#include <string>
#include <string_view>

namespace gt {

/// Where crash reports of a program go.
struct CrashSettings {
  std::string program;       ///< Its name.
  std::string folder = ".";  ///< Must exist. The report is crash-PROGRAM-PID.txt.
};

/// From now on this process writes a crash report when a signal ends it (report 5.5: the robot's
/// emon.log): signal, registers, stack, loaded modules with their build ids, the last notes, and
/// the call stack. Then it dies of that signal as it would have. Everything is prepared here, so
/// that the handler needs neither memory nor locks; what cannot be prepared is left out. Call it
/// once, when all libraries are loaded. What it prepares belongs to the process, as signals do.
void installCrashHandler(const CrashSettings& settings);

/// Notes a line for a crash report, which holds the last of them. From any thread, cheap; what is
/// longer than 120 bytes is cut.
void noteForCrashReport(std::string_view line);

/// Gives the calling thread a stack of its own for the crash handler while it lives, so that even
/// a stack overflow is reported. installCrashHandler() does so for the thread that calls it.
class CrashStack {
 public:
  CrashStack();
  ~CrashStack();
  CrashStack(const CrashStack&) = delete;
  CrashStack& operator=(const CrashStack&) = delete;

 private:
  void* memory_;
};

}  // namespace gt
