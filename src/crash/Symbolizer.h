#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "crash/CrashReport.h"
#include "crash/ElfFile.h"

namespace gt {

/// A place in the sources.
struct SourcePlace {
  std::string function;  ///< As in the sources; "?" if unknown.
  std::string file;      ///< Empty if unknown.
  int line = 0;
};

/// One instruction as text.
struct Instruction {
  std::uint64_t address = 0;  ///< In the crashed process.
  std::string text;
  SourcePlace place;
};

/// Turns the addresses of a crash report into places in the sources and into assembler. Binaries
/// are known by their build ids; if one was stripped, its symbols are looked for in the folders
/// given, and in Debian's (/usr/lib/debug): as .build-id/ab/cdef….debug, or under any name.
/// addr2line and objdump (binutils) read the debug information and the machine's code.
class Symbolizer {
 public:
  Symbolizer(const CrashReport& report, std::vector<std::string> symbolFolders);

  /// The place of an address, after it those that it was inlined into. Never empty.
  std::vector<SourcePlace> places(std::uint64_t address);
  /// The instructions round an address, at most `count` before it and behind it.
  Result<std::vector<Instruction>> assembler(std::uint64_t address, std::size_t count);
  /// Modules whose binary or symbols are not there, and why.
  const std::vector<Error>& missing() const { return missing_; }

 private:
  /// What is known of a module: where its code is, and where its symbols are.
  struct Files {
    std::optional<ElfFile> code, symbols;
  };

  Files& filesOf(const CrashModule& module);
  std::optional<ElfFile> findSymbols(const std::string& buildId) const;
  std::vector<SourcePlace> placesIn(const Files& files, std::uint64_t address) const;

  const CrashReport& report_;
  std::vector<std::string> folders_;
  std::map<const CrashModule*, Files> files_;
  std::vector<Error> missing_;
};

}  // namespace gt
