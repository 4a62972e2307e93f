#pragma once
#include <string>

#include "base/Result.h"

namespace gt {

/// The folder that holds the data which programs read: behavior, config, layouts, models, motions
/// and scenes. Files that a user names are relative to the working directory; defaults and names
/// without a path are files of the root.
class DataRoot {
 public:
  /// Where a root is looked for, in this order; places that are empty are passed over.
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
  /// The first root of: the option, the variable, ../share/gt2003 from the program (an installed
  /// tree), the folders above the program (a build tree in its sources), the sources. An option or
  /// variable that does not name a root is an error.
  static Result<DataRoot> find(const Places& places);

  /// The path of a file or folder of the root, such as "scenes/match.scene": relative if the root
  /// lies in the working directory, otherwise absolute.
  std::string path(const std::string& name) const;

 private:
  std::string folder_;  ///< Empty: the working directory.
};

}  // namespace gt
