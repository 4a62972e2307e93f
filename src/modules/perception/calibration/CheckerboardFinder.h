#pragma once
#include <vector>

#include "modules/perception/scanning/Horizon.h"
#include "representations/infrastructure/Image.h"
#include "streams/Reflection.h"

namespace gt {

/// A checkerboard that stands upright on the ground.
struct Checkerboard {
  int columns = 6;
  int rows = 4;
  double square = 50;
  double height = 75;

  static constexpr auto fields() {
    return Fields{field<&Checkerboard::columns>("number of inner corners in a row", {2, 30}),
                  field<&Checkerboard::rows>("number of inner corners in a column", {2, 30}),
                  field<&Checkerboard::square>(Unit::mm, "length of a square's edge", {1, 1000}),
                  field<&Checkerboard::height>(
                      Unit::mm, "height of the lowest inner corners above the ground", {0, 2000})};
  }
};

/// Finds the inner corners of a checkerboard, to a fraction of a pixel. A corner is where two
/// squares of each color meet: around it brightness changes four times (after Bennett and Lasenby,
/// ChESS: Quick and Robust Detection of Chess-board Features, 2014).
class CheckerboardFinder {
 public:
  /// Finds all corners (pixels), row by row from top left in the image. Returns false if any is
  /// missing.
  bool find(const Image& image, const Horizon& horizon, const Checkerboard& board,
            std::vector<Vector2d>& corners);
  /// All points of the last image (pixels) that look like a corner.
  const std::vector<Vector2d>& candidates() const { return candidates_; }

 private:
  /// A candidate's column and row on the board, counted from the first candidate.
  struct Place {
    std::size_t candidate;
    int column, row;
    Vector2d right, down;  ///< Approximate vectors to the next corners, pixels.
  };

  void measure(const Image& image);
  void collect(const Image& image);
  static Vector2d refine(const Image& image, Vector2d corner);
  const Vector2d* nearest(const Vector2d& from, const Vector2d& offset) const;
  bool grow(const Horizon& horizon);
  void step(const Place& from, int columns, int rows);

  std::vector<int> response_;  ///< For each pixel, how much it looks like a corner.
  std::vector<Vector2d> candidates_;
  std::vector<bool> used_;
  std::vector<Place> places_;
};

}  // namespace gt
