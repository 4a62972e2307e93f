#pragma once
#include <vector>

#include "modules/perception/scanning/CameraImage.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

struct GoalIndication;
class IndicationScanner;

/// Finds points on field lines, the field border and goals (report 3.2.2). Edges of white are
/// places where the y channel changes strongly between neighboring pixels. The distance between
/// rise and fall of the brightness distinguishes lines from the border.
class EdgeScanner {
 public:
  /// A point found: in the image (pixels), and on the ground relative to the robot (mm).
  struct EdgePoint {
    EdgeType type;
    Vector2d inImage, onGround;
  };

  /// Forgets what was found.
  void clear() { points_.clear(); }
  /// Scans a line perpendicular to the horizon, from top to bottom.
  void scanDown(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);
  /// Scans a line parallel to the horizon.
  void scanAcross(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);
  /// Adds the lower end of a part of a goal if the field begins there.
  void addGoal(const CameraImage& picture, const GoalIndication& goal);
  /// Fills in the percept. Drops types with fewer than three points as noise, and the border if it
  /// has far fewer points than the lines, since these are lines seen lengthwise.
  void finish(LinesPercept& percept);

  /// The points found; after `finish` without the dropped ones.
  const std::vector<EdgePoint>& points() const { return points_; }

 private:
  /// A bright section of a scan line that is followed by green. Positions in steps along the line.
  struct Bright {
    double rise = 0, fall = 0;
    bool riseSeen = false;  ///< Whether it begins within the image.
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

/// Scans all lines of a grid for objects and for points on edges.
void scan(const CameraImage& picture, const ScanGrid& grid, const FieldDimensions& field,
          IndicationScanner& objects, EdgeScanner& edges);

}  // namespace gt
