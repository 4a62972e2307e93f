#pragma once
#include <array>
#include <span>

#include "modules/perception/scanning/IndicationScanner.h"
#include "modules/perception/specialists/EdgeAngles.h"

namespace gt {

/// Measures the flags that were met by scan lines (report 3.2.4).
class FlagSpecialist {
 public:
  /// Fills in the percept's flags.
  void find(const CameraImage& picture, std::span<const FlagIndication> indications,
            const FieldDimensions& field, LandmarksPercept& percept);

 private:
  /// Indications close to each other, perhaps of different flags.
  struct Cluster {
    Vector2d newest = Vector2d::Zero();  ///< In the horizon's system, pixels.
    std::array<int, 6> votes{};
    std::array<Vector2d, 6> sums;
  };
  /// One flag being measured.
  struct Measurement {
    ColorSet upper, lower, pink, other;
    bool pinkAbove = false, otherIsGreen = false;
    /// Heights of the two colors from where they meet, pixels.
    double heightAbove = 0, heightBelow = 0;
    bool aboveOnBorder = false, belowOnBorder = false;
    bool aboveGoesOn = false;  ///< Whether the color continues above a flag's height.
  };
  /// Numbers of test points that lie in the image, and that have one of some colors.
  struct Places {
    int inside = 0, colored = 0;
  };

  void cluster(const CameraImage& picture, std::span<const FlagIndication> indications);
  static void keep(const FlagPercept& flag, LandmarksPercept& percept);
  bool measure(const CameraImage& picture, const Vector2d& start, const FieldDimensions& field,
               FlagPercept& flag);
  bool measureHeights(const CameraImage& picture, const Vector2d& start, Measurement& m) const;
  void scanRows(const CameraImage& picture, const Vector2d& start, double offset, ColorSet colors,
                double& widest);
  bool scanWidth(const CameraImage& picture, const Vector2d& start, const Measurement& m);
  Places look(const CameraImage& picture, const Vector2d& start, double from, double height,
              ColorSet colors) const;
  bool isSolid(const CameraImage& picture, const Vector2d& start, const Measurement& m) const;
  bool standsOnPole(const CameraImage& picture, const Vector2d& start, const Measurement& m) const;
  bool isPaleRed(const CameraImage& picture, const Vector2d& start, const Measurement& m) const;
  void scanColumns(const CameraImage& picture, const Vector2d& start, const Measurement& m);

  std::array<Cluster, 16> clusters_;
  std::size_t used_ = 0;
  EdgeAngles left_, right_, top_, bottom_;
  double leftmost_ = 0, rightmost_ = 0;  ///< Pixels along the horizon from the start.
};

/// Computes distance (mm) and angle (rad) of a flag, relative to the robot, from its boundary and
/// the elevation `middle` (rad) at which its colors meet (report 3.2.4). Returns false if no flag
/// can look like that.
bool locateFlag(const CameraMatrix& matrix, const FieldDimensions& field, double middle,
                FlagPercept& flag);

}  // namespace gt
