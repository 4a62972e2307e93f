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
/// Its robots read the files of that program's tree, and those of a team: NAME of the tree's folder
/// teams, or the folder of that path.
struct TeamProgram {
  std::string file;  ///< Of the program, absolute.
  DataRoot root;     ///< What its robots read.
  std::string team;  ///< As `teamFolder` takes it; empty if none.
};

/// Whether a team is one with a program, by its name.
bool namesProgram(const std::string& team);

/// The team of such a name. What a commit needs is built, or lies in the cache: the folder
/// gt2003/teams/COMMIT in $XDG_CACHE_HOME, by default ~/.cache. Who builds the same at the same
/// time waits for it.
Result<TeamProgram> teamProgram(const std::string& team, const DataRoot& root);

/// The name with the whole hash of the commit: it means the same for ever. The root tells the
/// repository; without one there, it is that of the sources from which this program was built.
Result<std::string> resolvedTeam(const std::string& team, const DataRoot& root);

}  // namespace gt
