#pragma once
#include <array>
#include <span>
#include <vector>

#include "modules/perception/scanning/IndicationScanner.h"
#include "modules/perception/specialists/BallView.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// Finds the ball from its sections on scan lines (report 3.2.3).
class BallSpecialist {
 public:
  /// Fills in the percept except `time`. `segments` must be in the order of their scan lines.
  /// `ballRadius` in mm.
  void find(const CameraImage& picture, std::span<const BallSegment> segments, double ballRadius,
            BallPercept& percept);

 private:
  /// A point of the ball's boundary.
  struct BoundaryPoint {
    Vector2d position = Vector2d::Zero();
    ColorClass beyond = ColorClass::noColor;
    bool upper = false;
  };
  /// Segments that may belong to one ball.
  struct Cluster {
    Vector2d low, high;  ///< Corners of its bounding box, pixels.
    int orange = 0;
    std::vector<std::size_t> segments;
  };
  void cluster(std::span<const BallSegment> segments);
  bool look(const CameraImage& picture, std::span<const BallSegment> segments,
            const Cluster& cluster, double ballRadius, BallPercept& percept);
  void collectPoints(std::span<const BallSegment> segments, const Cluster& cluster);
  void learnColor(const CameraImage& picture, const Cluster& cluster);
  bool isBall(const Pixel& pixel, ColorClass color) const;
  static bool isBoundary(const CameraImage& picture, const Vector2d& edge, const Vector2d& way);
  void traceBoundary(const CameraImage& picture, const Vector2d& inside);
  bool locate(const CameraImage& picture, std::span<const BallSegment> segments,
              const Cluster& cluster, double ballRadius, BallCone& cone);
  bool circleCone(const CameraImage& picture, BallCone& cone) const;
  bool pointCone(const CameraImage& picture, double ballRadius, BallCone& cone) const;
  bool fitCone(const CameraImage& picture, BallCone& cone) const;
  bool isOnGreen(const CameraImage& picture, const BallPercept& percept) const;
  bool isOrange(const CameraImage& picture, const BallPercept& percept) const;

  std::vector<Cluster> clusters_;
  std::size_t used_ = 0;
  std::vector<BoundaryPoint> points_;
  int traced_ = 0;          ///< Number of paths from within the ball that ended within the image.
  double cb_ = 0, cr_ = 0;  ///< Mean chroma of the ball's pixels in the current cluster.
};

}  // namespace gt
