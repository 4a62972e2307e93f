#pragma once
#include <string>

namespace gt {

/// The folder for crash reports, crashes in the user's folder for state (UserFolder.h); in /tmp if
/// the user has none.
std::string crashFolder();

/// The name of the program and the folder for its crash reports.
struct CrashSettings {
  std::string program;  ///< Name of the program.
  /// Made when a report is written. The report is crash-PROGRAM-PID.txt.
  std::string folder = crashFolder();
};

/// From now on this process writes a crash report when a signal ends it (report 5.5: the robot's
/// emon.log): signal, registers, stack, loaded modules with their build ids, what ran, the last
/// notes, and the call stack. A line on stderr names the report. Then the process dies of that
/// signal as it would have. Everything is prepared here, so that the handler needs neither memory
/// nor locks; what cannot be prepared is left out. Call it once, when all libraries are loaded.
/// What it prepares belongs to the process, as signals do.
void installCrashHandler(const CrashSettings& settings);

/// Gives the calling thread a stack of its own for the crash handler while it exists, so that even
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
