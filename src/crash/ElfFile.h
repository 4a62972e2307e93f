#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// A function as a symbol table has it.
struct ElfFunction {
  std::string name;  ///< As the linker knows it.
  std::uint64_t begin = 0, size = 0;
};

/// What crash reports need of a program or library (64-bit ELF): its build id and its functions.
class ElfFile {
 public:
  /// Reads a file. Returns an error if it is not a 64-bit ELF file. Safe on any input.
  static Result<ElfFile> read(const std::string& path);

  const std::string& path() const { return path_; }
  const std::string& buildId() const { return buildId_; }  ///< In hex; empty if it has none.
  /// Whether it has information about source lines.
  bool hasLines() const { return hasLines_; }
  /// The function at an address of the file; empty if no symbol covers it.
  std::optional<ElfFunction> functionAt(std::uint64_t address) const;
  bool hasFunctions() const { return !functions_.empty(); }

 private:
  friend class ElfParser;
  std::string path_, buildId_;
  std::vector<ElfFunction> functions_;
  bool hasLines_ = false;
};

}  // namespace gt
