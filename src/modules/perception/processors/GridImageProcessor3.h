#pragma once
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

namespace gt {

/// Finds a black and white ball instead of an orange one (report 4.1), all else as GT2003 does, the
/// solution GridImageProcessor3 of the ImageProcessor.
class GridImageProcessor3 {
 public:
  void update(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
              const FieldDimensions& field, BallPercept& ball, LandmarksPercept& landmarks,
              LinesPercept& lines, PlayersPercept& players, ObstaclesPercept& obstacles,
              Random& random, Debug& debug);

 private:
  GT2003ImageProcessor vision_;
  BlackWhiteBallSpecialist ballSpecialist_;
};

}  // namespace gt
