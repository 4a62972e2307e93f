#pragma once
#include <vector>

#include "modules/perception/scanning/CameraImage.h"
#include "modules/perception/scanning/FlagColors.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A section of a scan line on a ball (report 3.2.3). Points in the image, in pixels.
struct BallSegment {
  double u = 0;  ///< `u` of its scan line.
  Vector2d upper = Vector2d::Zero(), lower = Vector2d::Zero();
  bool upperKnown = false, lowerKnown = false;  ///< Whether the ends lie on the ball's boundary.
  ColorClass above = ColorClass::noColor, below = ColorClass::noColor;
  int orange = 0;  ///< Number of orange pixels.
};

/// A point on a scan line that looks like the middle of a flag (report 3.2.1).
struct FlagIndication {
  FlagType type = FlagType::pinkAboveYellow;
  Vector2d position = Vector2d::Zero();  ///< Between the two colors, pixels.
};

/// A section of a scan line on a goal that ends on the field (report 3.2.1). Points in pixels.
struct GoalIndication {
  GoalColor color = GoalColor::yellow;
  Vector2d top = Vector2d::Zero(), bottom = Vector2d::Zero();
  bool topKnown = true;     ///< False if its color continues above the height of a goal.
  bool meetsField = false;  ///< Whether green begins right below it, at `foot`.
  Vector2d foot = Vector2d::Zero();
};

/// A section of a scan line on a tricot (report 3.2.6). Points in pixels.
struct PlayerIndication {
  TeamColor team = TeamColor::red;
  double u = 0;  ///< `u` of its scan line.
  Vector2d upper = Vector2d::Zero(), lower = Vector2d::Zero();
  bool upperKnown = false, lowerKnown = false;  ///< Whether the ends lie within the image.
  int pixels = 0;
};

/// The green section at the lower end of a scan line (report 3.2.7). Points in pixels.
struct GreenSection {
  Vector2d begin = Vector2d::Zero(), end = Vector2d::Zero();
  bool beginOnBorder = false;
};

/// Scans lines of a grid pixel by pixel and collects sections that look like objects (report
/// 3.2.1).
class IndicationScanner {
 public:
  std::vector<BallSegment> balls;
  std::vector<FlagIndication> flags;
  std::vector<GoalIndication> goals;
  std::vector<PlayerIndication> players;
  std::vector<GreenSection> greens;  ///< One for each scan line that crosses the whole image.

  /// Forgets what was found.
  void clear();
  void scan(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);

 private:
  /// Adjacent pixels of one class, as indices along the scan line.
  struct Run {
    ColorClass color;
    int begin, end;  ///< The first pixel and the one after the last.

    int length() const { return end - begin; }
  };
  /// Runs of some classes with small gaps between them.
  struct Stretch {
    std::size_t first, last;  ///< Indices of runs.
    int pixels;               ///< Number of pixels without the gaps.
  };

  void findRuns(const CameraImage& picture, const ScanLine& line);
  Stretch stretchFrom(std::size_t first, ColorSet classes, int maxGap) const;
  Stretch ballFrom(std::size_t first) const;
  std::size_t findBall(const ScanLine& line, std::size_t first);
  void findFlag(const ScanLine& line, std::size_t first);
  void findPlayer(const ScanLine& line, const Stretch& tricot, TeamColor team);
  void findGreen(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);
  static bool isSeenLengthwise(const CameraImage& picture, const Vector2d& middle, double distance,
                               const FieldDimensions& field);
  static Vector2d greenEnd(const CameraImage& picture, const ScanLine& line, int begin);
  bool isHidden(const Stretch& goal) const;
  static void cutOff(const CameraImage& picture, const FieldDimensions& field,
                     GoalIndication& goal);
  std::size_t findGoal(const CameraImage& picture, const ScanLine& line,
                       const FieldDimensions& field, std::size_t first);

  std::vector<ColorClass> classes_;  ///< Classes of the pixels of the scan line.
  std::vector<Run> runs_;
};

}  // namespace gt
