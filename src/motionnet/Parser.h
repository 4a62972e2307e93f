#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "motionnet/Diagnostic.h"
#include "motionnet/Net.h"

namespace motionnet {

/// A line of a motion description that makes a node; names are not yet resolved.
struct Statement {
  Node node;
  std::string requested, motion, label;  ///< Of a transition.
};

/// One motion description.
struct Motion {
  std::string file;
  std::string name;
  int nameLine = 0;
  std::vector<Statement> statements;
  struct Label {
    int statement;  ///< Index of the statement that follows it.
    int line;
  };
  std::map<std::string, Label> labels;
  struct Group {
    std::vector<std::string> members;
    int line;
  };
  std::map<std::string, Group> groups;
};

/// Reads one motion description (report 5.4). Its lines are
///
///     motion_id = NAME                    the first line; NAME also names the file
///     group NAME = MOTION MOTION ...      a name for several motions, known in all files
///     label NAME                          a place to jump to; each motion has the label start
///     A1 ... An INTERPOLATE COUNT         angles of all joints in mrad or ~ (don't care); 1: reach
///                                         them within COUNT frames, 0: send them COUNT times
///     pid JOINT P I D                     gains of a joint from here on
///     odometry X Y ROTATION               speed of the robot from here on: mm/s, mm/s, mrad/s
///     transition REQUESTED MOTION LABEL   go there if REQUESTED (a motion, a group or allMotions)
///                                         is requested
///
/// and comments from // to the end of a line. What is wrong is appended to the errors.
Motion parse(std::string_view text, std::string_view file, const Rules& rules,
             std::vector<Diagnostic>& errors);

}  // namespace motionnet
