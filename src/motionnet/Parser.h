#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motionnet/Diagnostic.h"
#include "motionnet/Net.h"

namespace motionnet {

/// A line of a motion description that defines a node; its names are not yet resolved.
struct Statement {
  Node node;
  std::string requested, motion, label;  ///< Of a transition.
  std::string posture;                   ///< Of data that uses the angles of a posture.
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
  struct Posture {
    std::vector<std::optional<int>> angles;
    int line;
  };
  std::map<std::string, Posture> postures;
};

/// Reads one motion description (report 5.4). Its lines are
///
///     motion_id = NAME                    the first line; NAME also names the file
///     group NAME = MOTION MOTION ...      a name for several motions, known in all files
///     posture NAME = A1 ... An            a name for angles of all joints, known in all files
///     value NAME = NUMBER                 a name that stands for the number in the lines below
///     label NAME                          a place to jump to; each motion has the label start
///     A1 ... An INTERPOLATE COUNT         angles of all joints in mrad or ~ (don't care); 1: reach
///                                         them within COUNT frames, 0: send them COUNT times
///     posture NAME INTERPOLATE COUNT      the same with the angles of a posture
///     pid JOINT P I D                     gains of a joint's servo from here to the motion's end
///     odometry X Y ROTATION               speed of the robot from here on: mm/s, mm/s, mrad/s
///     displacement X Y ROTATION           where the next line of angles brings the robot, from
///                                         where it began: mm, mm, mrad
///     transition REQUESTED MOTION LABEL   go there if REQUESTED (a motion, a group or allMotions)
///                                         is requested
///
/// and comments from // to the end of a line. What is wrong is appended to the errors.
Motion parse(std::string_view text, std::string_view file, const Rules& rules,
             std::vector<Diagnostic>& errors);

}  // namespace motionnet
