#pragma once
#include "modules/perception/colors/ColorAdaptation.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"

namespace gt {

/// Solution *GridImageProcessor2* of ImageProcessor: finds what GT2003 finds without a color table
/// made by hand. It adapts to the colors of the environment while the robot plays (report 6.2.1).
class GridImageProcessor2 {
 public:
  /// Provides what GT2003 provides, with the same limits; nothing until it knows the carpet's
  /// green.
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
  std::vector<std::pair<Vector2d, ColorClass>> learned_;  ///< Of the image, if somebody watches.
  bool watched_ = false;
};

}  // namespace gt
