#pragma once
#include <array>
#include <vector>

#include "representations/infrastructure/Joints.h"
#include "representations/motion/MotionNet.h"

namespace gt {

/// Lines of joint data that a person sends to a robot to try a motion (report J.5.4: execute, loop,
/// stop). A sequence without lines stops the present one.
struct JointDataSequence {
  /// One line of a motion description.
  struct Line {
    std::array<double, MotionNet::jointCount> angles{};
    std::array<bool, MotionNet::jointCount> dontCare{};
    bool interpolate = false;
    int frames = 1;

    static constexpr auto fields() {
      return Fields{field<&Line::angles>(Unit::rad),
                    field<&Line::dontCare>("joints that keep their angles"),
                    field<&Line::interpolate>(
                        "whether the angles are interpolated and reached at the end of the line"),
                    field<&Line::frames>(Unit::frames, "duration in frames of 8 ms", {1, 10000})};
    }
  };

  std::vector<Line> lines;
  bool loop = false;
  int number = 0;

  static constexpr auto fields() {
    return Fields{field<&JointDataSequence::lines>(),
                  field<&JointDataSequence::loop>("whether the sequence is repeated"),
                  field<&JointDataSequence::number>(
                      "number of the sequence; another number starts it again")};
  }
};

}  // namespace gt
