#pragma once
#include <string>
#include <vector>

#include "base/DataRoot.h"

namespace gt {

/// What `simgt fault-report` packs.
struct FaultReportOptions {
  DataRoot root;
  std::string out = "out/fault.tar.gz";
  std::vector<std::string> results;  ///< Files and folders: results of a match, logs, states.
  std::vector<std::string> crashes;  ///< Crash reports; if none is named, the newest one.
  std::string note;                  ///< What went wrong, in a sentence.
};

/// Packs what it takes to look into a fault elsewhere into one file: the results that are named
/// with their seeds, a crash report, the root's files that robots read, and the versions of program
/// and machine. Prints what is in it. An error if something that was named cannot be read.
Result<void> packFaultReport(const FaultReportOptions& options);

}  // namespace gt
