#pragma once
#include "modules/perception/colors/ColorAdaptation.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"

namespace gt {

/// Solution *GridImageProcessor2* of ImageProcessor: finds the same objects as GT2003, but without
/// a color table made by hand. It adapts to the colors of the environment while the robot plays
/// (report 6.2.1).
class GridImageProcessor2 {
 public:
  /// Provides the same percepts as GT2003, under the same conditions; no percepts until the green
  /// of the carpet is learned.
  void update(const Image& image, const CameraMatrix& matrix, const FieldDimensions& field,
              Percepts found, Debug& debug);

  const ColorAdaptation& colors() const { return colors_; }

 private:
  void learn(const CameraImage& picture, const BallPercept& ball);
  void learn(const CameraImage& picture, const LandmarksPercept& landmarks);
  void learn(const CameraImage& picture, const PlayersPercept& players);
  void learnAt(const CameraImage& picture, const Vector2d& point, ColorClass color);
  void draw(const Image& image, Debug& debug) const;

  ImageCorrection correction_;
  ColorAdaptation colors_;
  GT2003ImageProcessor vision_;
  /// Pixels of the image that were learned from, if a drawing is requested.
  std::vector<std::pair<Vector2d, ColorClass>> learned_;
  bool watched_ = false;
};

}  // namespace gt
