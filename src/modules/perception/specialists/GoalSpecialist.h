#pragma once
#include <span>
#include <vector>

#include "modules/perception/scanning/IndicationScanner.h"
#include "modules/perception/specialists/EdgeAngles.h"

namespace gt {

/// Measures the goals that were met by scan lines (report 3.2.5).
class GoalSpecialist {
 public:
  /// Fills in the percept's goals; the indications must be in the order of their scan lines.
  void find(const CameraImage& picture, std::span<const GoalIndication> indications,
            const FieldDimensions& field, LandmarksPercept& percept);

 private:
  void selectGroup(const CameraImage& picture, std::span<const GoalIndication> indications,
                   GoalColor color);
  bool measure(const CameraImage& picture, const FieldDimensions& field, GoalPercept& goal);
  void scanRows(const CameraImage& picture, const GoalIndication& from,
                const FieldDimensions& field, ColorSet colors, double sign, EdgeAngles& edge);
  const GoalIndication& outermost(bool left) const;
  const GoalIndication& highest() const;
  void scanColumn(const CameraImage& picture, const GoalIndication& at, ColorSet colors);

  std::vector<GoalIndication> members_, group_;
  EdgeAngles left_, right_, top_, bottom_;
  bool cutOff_ = false;  ///< Whether the image's border cuts off one of its sides.
};

/// Computes distance (mm) and angle (rad) of a goal, relative to the robot, from its boundary
/// (report 3.2.5). `cutOff`: whether the image's border cuts off one of its sides. Returns false if
/// no goal can look like that.
bool locateGoal(const CameraMatrix& matrix, const FieldDimensions& field, bool cutOff,
                GoalPercept& goal);

}  // namespace gt
