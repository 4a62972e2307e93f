#pragma once
#include <vector>

#include "modules/perception/scanning/CameraImage.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

struct GoalIndication;
class IndicationScanner;

/// Finds points on the edges of field lines, the border and goals (report 3.2.2). Edges of white
/// are places where the y channel changes much between neighboring pixels; how far increase and
/// decrease lie apart distinguishes lines from the border.
class EdgeScanner {
 public:
  /// A point found, in the image.
  struct EdgePoint {
    EdgeType type;
    Vector2d inImage, onGround;
  };

  /// Forgets what was found.
  void clear() { points_.clear(); }
  /// Looks along a line perpendicular to the horizon, from top to bottom.
  void scanDown(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);
  /// Looks along a line parallel to the horizon.
  void scanAcross(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);
  /// Takes the lower end of a piece of goal if the field begins there.
  void addGoal(const CameraImage& picture, const GoalIndication& goal);
  /// Fills in the percept: types with less than three points are noise, and a border with far fewer
  /// points than the lines is made of lines seen lengthwise.
  void finish(LinesPercept& percept);

  /// What `finish` has kept.
  const std::vector<EdgePoint>& points() const { return points_; }

 private:
  /// Something white that green follows on a scan line, in steps along it.
  struct Bright {
    double rise = 0, fall = 0;
    bool riseSeen = false;  ///< It began within the image.
    bool greenBefore = false;
  };

  void findBright(const CameraImage& picture, const ScanLine& line);
  double sharpest(int at) const;
  void classify(const CameraImage& picture, const ScanLine& line, const Bright& bright,
                double longestLine);
  void add(const CameraImage& picture, EdgeType type, const Vector2d& inImage);

  std::vector<std::uint8_t> y_, steep_;
  std::vector<Bright> bright_;
  std::vector<EdgePoint> points_;
};

/// Looks along all lines of a grid, for objects and for points on edges.
void scan(const CameraImage& picture, const ScanGrid& grid, const FieldDimensions& field,
          IndicationScanner& objects, EdgeScanner& edges);

}  // namespace gt
