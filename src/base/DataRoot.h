#pragma once
#include <string>

#include "base/Result.h"

namespace gt {

/// The folder of the data that programs read: behavior, config, layouts, models, motions and
/// scenes. Paths that a user enters are relative to the working directory. Default files and names
/// without a path are searched in the root.
class DataRoot {
 public:
  /// Places where the root is searched, in this order; empty ones are skipped.
  struct Places {
    std::string option;    ///< Value of the option --root.
    std::string variable;  ///< Value of the environment variable GT2003_ROOT.
    std::string program;   ///< Path of the running program.
    std::string sources;   ///< Folder of the sources that the program was built from.
  };

  /// The working directory, for tests: they run in the root of the sources.
  DataRoot() = default;
  explicit DataRoot(const std::string& folder);

  /// The places of the running program. `option` is empty if the option is not given.
  static Places places(const std::string& option);
  /// Returns the first root among: the option, the variable, ../share/gt2003 relative to the
  /// program (an installed tree), the folders above the program (a build tree in its sources), the
  /// sources. Returns an error if the option or the variable names a folder that is not a root.
  static Result<DataRoot> find(const Places& places);

  /// The path of a file or folder of the root, such as "scenes/match.scene". The path is relative
  /// if the root lies in the working directory, otherwise absolute.
  std::string path(const std::string& name) const;

 private:
  std::string folder_;  ///< Empty: the working directory.
};

}  // namespace gt
