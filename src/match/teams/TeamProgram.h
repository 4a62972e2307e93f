#pragma once
#include <string>

#include "base/DataRoot.h"
#include "base/Result.h"

namespace gt {

/// A team whose robots run a program of their own, in lockstep with the simulation. It is named
///
///     commit:REVISION[:TEAM]   the program that is built from a commit of the sources' repository
///     program:FILE[:TEAM]      a program gtrobot-robot that has been built
///
/// Its robots read the files of that program's tree, and those of a team: NAME in the tree's folder
/// teams, or the folder of that path.
struct TeamProgram {
  std::string file;  ///< Absolute path of the program.
  DataRoot root;     ///< From which its robots read their files.
  std::string team;  ///< As `teamFolder` takes it; empty if none.
};

/// Whether a name denotes a team with a program.
bool namesProgram(const std::string& team);

/// The team of a name that denotes a program. The program of a commit is built unless it is in the
/// cache: the folder gt2003/teams/COMMIT in $XDG_CACHE_HOME, by default ~/.cache. If another
/// process builds the same commit, waits for it.
Result<TeamProgram> teamProgram(const std::string& team, const DataRoot& root);

/// The name with the whole hash of the commit, so that it always denotes the same program. The
/// repository is that of the root, or if the root is in none, that of the sources from which this
/// program was built.
Result<std::string> resolvedTeam(const std::string& team, const DataRoot& root);

}  // namespace gt
