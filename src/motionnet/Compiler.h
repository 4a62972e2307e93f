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

/// The result of compiling: a net, or the errors in the descriptions.
struct Compilation {
  Net net;  ///< Usable only without errors.
  std::vector<Diagnostic> errors;

  explicit operator bool() const { return errors.empty(); }
};

/// Compiles a set of motion descriptions (see Parser.h) to one net and checks it for consistency:
/// no missing transition from one motion to another or out of the net, no unknown motion, label or
/// group, no label and no line that is never reached, no endless loop without data. The entry and
/// exit, extern (report 3.9.2, 5.4), has a transition to the start of each motion, unless a file
/// describes it.
Compilation compile(const std::vector<Source>& sources, const Rules& rules);

/// Reads the motion descriptions of a folder and its subfolders.
std::vector<Source> readFolder(const std::string& folder, std::vector<Diagnostic>& errors);

/// The data nodes of a text in the order of its lines, without its transitions and labels, to try
/// an unfinished motion (report J.5.4). The text need not name a motion. It may use its own
/// postures and those of other descriptions.
std::vector<Node> dataOf(const Source& text, const std::vector<Source>& others, const Rules& rules,
                         std::vector<Diagnostic>& errors);

/// Compiles all `.mof` files of a folder and its subfolders. A folder that cannot be read is an
/// error, too.
Compilation compileFolder(const std::string& folder, const Rules& rules);

}  // namespace motionnet
