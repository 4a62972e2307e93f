#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/Random.h"
#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {

/// Finds a black and white ball by its edges: Sobel filter, Hough transform with eleven radii, and
/// a test whether the circle is filled with black and white (report 4.1.1).
class BlackWhiteBallSpecialist {
 public:
  /// A point (pixels) where the image changes strongly from left to right.
  struct Edge {
    Vector2d point;
    Vector2d inward = Vector2d::Zero();  ///< Unit vector along the gradient into the ball.
    bool onBall = false;                 ///< Whether it may be on the ball's boundary.
  };

  /// Fills in the percept except `time`. `ballRadius` in mm.
  void find(const CameraImage& picture, double ballRadius, Random& random, BallPercept& percept);

  const std::vector<Edge>& edges() const { return edges_; }

 private:
  static constexpr std::size_t radii = 11;

  void findEdges(const CameraImage& picture, double ballRadius);
  void scanRow(const CameraImage& picture, int y, int from, int to);
  void testEdge(const CameraImage& picture, int x, int y, const Vector2d& gradient);
  void vote(const CameraImage& picture, double ballRadius);
  void voteFor(const Edge& edge, std::size_t radius, double pixels);
  bool look(const CameraImage& picture, std::size_t cell, double ballRadius, Random& random,
            BallPercept& percept);
  static bool traceCircle(const CameraImage& picture, Vector2d& center, double& radius);
  static bool isFull(const CameraImage& picture, const Vector2d& center, double radius,
                     Random& random);
  Vector2d cellCenter(std::size_t cell) const;

  std::vector<Edge> edges_;
  std::array<double, radii> radius_{};  ///< pixels
  int cellsX_ = 0, cellsY_ = 0;
  std::vector<std::uint16_t> votes_;     ///< For each radius, row by row.
  std::vector<std::size_t> candidates_;  ///< Cells with enough votes.
};

}  // namespace gt
