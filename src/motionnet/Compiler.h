#pragma once
#include <string>
#include <vector>

#include "motionnet/Diagnostic.h"
#include "motionnet/Net.h"

namespace motionnet {

/// A file of the set of motion descriptions.
struct Source {
  std::string file;
  std::string text;
};

/// A net, or what keeps the descriptions from being one.
struct Compilation {
  Net net;  ///< Usable only without errors.
  std::vector<Diagnostic> errors;

  explicit operator bool() const { return errors.empty(); }
};

/// Compiles a set of motion descriptions (see Parser.h) to one net and checks it for consistency:
/// no missing transition from one motion to another or out of the net, no unknown motion, label or
/// group, no label and no line that is never reached, no endless loop without data. The entry and
/// exit, extern (report 3.9.2, 5.4), has a transition to the start of each motion, if no file
/// describes it otherwise.
Compilation compile(const std::vector<Source>& sources, const Rules& rules);

/// The motion descriptions of a folder and of those in it.
std::vector<Source> readFolder(const std::string& folder, std::vector<Diagnostic>& errors);

/// The data of a text in the order of its lines, whatever its transitions and labels; for trying a
/// motion that is not finished yet (report J.5.4). The text need not name a motion; its postures
/// are its own and those of other descriptions.
std::vector<Node> dataOf(const Source& text, const std::vector<Source>& others, const Rules& rules,
                         std::vector<Diagnostic>& errors);

/// Compiles all `.mof` files of a folder and of those in it. A folder that cannot be read is an
/// error, too.
Compilation compileFolder(const std::string& folder, const Rules& rules);

}  // namespace motionnet
