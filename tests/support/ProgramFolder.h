#pragma once
#include <filesystem>
#include <string>

namespace gt {

/// Where the programs are that were built with a test: where the test's own program is. No compile
/// command names it, so that the compiler cache serves other folders.
inline std::string programFolder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().string();
}

}  // namespace gt
