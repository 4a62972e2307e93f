#pragma once
#include "modules/perception/colors/ColorAdaptation.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"

namespace gt {

/// Finds what GT2003 finds without a colour table made by hand: it adapts to the colours of the
/// environment while the robot plays (report 6.2.1), the solution GridImageProcessor2 of the
/// ImageProcessor.
class GridImageProcessor2 {
 public:
  void update(const Image& image, const CameraMatrix& matrix, const FieldDimensions& field,
              BallPercept& ball, LandmarksPercept& landmarks, LinesPercept& lines,
              PlayersPercept& players, ObstaclesPercept& obstacles, Debug& debug);

  const ColorAdaptation& colors() const { return colors_; }

 private:
  void learn(const Picture& picture, const BallPercept& ball);
  void learn(const Picture& picture, const LandmarksPercept& landmarks);
  void learn(const Picture& picture, const PlayersPercept& players);
  void learnAt(const Picture& picture, const Vector2d& point, ColorClass color);
  void draw(const Image& image, Debug& debug) const;

  ColorAdaptation colors_;
  GT2003ImageProcessor vision_;
  std::vector<std::pair<Vector2d, ColorClass>> learned_;  ///< Of the last picture, for drawings.
};

}  // namespace gt
