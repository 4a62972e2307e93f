#pragma once
#include <vector>

#include "modules/perception/scanning/CameraImage.h"
#include "modules/perception/scanning/FlagColors.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A piece of ball on a scan line (report 3.2.3).
struct BallSegment {
  double u = 0;  ///< Of its scan line.
  Vector2d upper = Vector2d::Zero(), lower = Vector2d::Zero();
  bool upperKnown = false, lowerKnown = false;  ///< Whether these lie on the ball's boundary.
  ColorClass above = ColorClass::noColor, below = ColorClass::noColor;
  int orange = 0;  ///< Pixels.
};

/// A place on a scan line that looks like the middle of a flag (report 3.2.1).
struct FlagIndication {
  FlagType type = FlagType::pinkAboveYellow;
  Vector2d position = Vector2d::Zero();  ///< Between the two colors.
};

/// A piece of goal on a scan line that ends on the field (report 3.2.1).
struct GoalIndication {
  GoalColor color = GoalColor::yellow;
  Vector2d top = Vector2d::Zero(), bottom = Vector2d::Zero();
  bool topKnown = true;     ///< False where it goes on in its color beyond a goal's height.
  bool meetsField = false;  ///< Green begins right below it, at `foot`.
  Vector2d foot = Vector2d::Zero();
};

/// A piece of tricot on a scan line (report 3.2.6).
struct PlayerIndication {
  TeamColor team = TeamColor::red;
  double u = 0;  ///< Of its scan line.
  Vector2d upper = Vector2d::Zero(), lower = Vector2d::Zero();
  bool upperKnown = false, lowerKnown = false;  ///< Whether these ends lie within the image.
  int pixels = 0;
};

/// The green that reaches down to the end of a scan line (report 3.2.7).
struct GreenSection {
  Vector2d begin = Vector2d::Zero(), end = Vector2d::Zero();
  bool beginOnBorder = false;
};

/// Scans lines of a grid pixel by pixel and collects what looks like something (report 3.2.1).
class IndicationScanner {
 public:
  std::vector<BallSegment> balls;
  std::vector<FlagIndication> flags;
  std::vector<GoalIndication> goals;
  std::vector<PlayerIndication> players;
  std::vector<GreenSection> greens;  ///< One for each line that reaches over the whole image.

  /// Forgets what was found.
  void clear();
  void scan(const CameraImage& picture, const ScanLine& line, const FieldDimensions& field);

 private:
  /// Neighboring pixels of one class.
  struct Run {
    ColorClass color;
    int begin, end;  ///< The first pixel and the one after the last.

    int length() const { return end - begin; }
  };
  /// Neighboring runs of a class with small gaps.
  struct Stretch {
    std::size_t first, last;  ///< Runs.
    int pixels;               ///< Without the gaps.
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

  std::vector<ColorClass> classes_;  ///< Of the pixels.
  std::vector<Run> runs_;
};

}  // namespace gt
