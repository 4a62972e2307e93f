#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "crash/CrashReport.h"

struct Dwfl;
struct Dwfl_Module;

namespace gt {

/// A place in the sources.
struct SourcePlace {
  std::string function = "?";  ///< As in the sources; "?" if unknown.
  std::string file;            ///< Empty if unknown.
  int line = 0;
};

/// One instruction as text.
struct Instruction {
  std::uint64_t address = 0;  ///< In the crashed process.
  std::string text;
  SourcePlace place;
};

/// Converts the addresses of a crash report to places in the sources and to assembler. Binaries are
/// identified by their build ids. The symbols of a stripped binary are searched in the given
/// folders, and in Debian's (/usr/lib/debug): as .build-id/ab/cdef….debug, or under any name.
/// elfutils read symbols and debug information, objdump (binutils) disassembles the code. Safe on
/// any file.
class Symbolizer {
 public:
  Symbolizer(const CrashReport& report, const std::vector<std::string>& symbolFolders);

  /// The place of an address, followed by the places into which it was inlined. Never empty.
  std::vector<SourcePlace> places(std::uint64_t address);
  /// The instructions round an address, at most `count` before it and behind it.
  Result<std::vector<Instruction>> assembler(std::uint64_t address, std::size_t count);
  /// Modules whose binary or symbols were not found, and the reasons.
  const std::vector<Error>& missing() const { return missing_; }

 private:
  struct Files {
    std::string code;  ///< Empty if it is not there.
    std::shared_ptr<Dwfl> session;
    Dwfl_Module* symbols = nullptr;  ///< Of the session; null if there is no file.

    /// Reads symbols from a file. Returns whether they include source lines.
    bool open(const std::string& path);
  };

  Files& filesOf(const CrashModule& module);

  const CrashReport& report_;
  std::multimap<std::string, std::string> symbols_;  ///< Files of the folders by their build ids.
  std::map<const CrashModule*, Files> files_;
  std::vector<Error> missing_;
};

}  // namespace gt
