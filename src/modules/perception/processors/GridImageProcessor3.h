#pragma once
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/specialists/BallSpotSpecialist.h"
#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

namespace gt {

/// Solution *GridImageProcessor3* of ImageProcessor: finds a black and white ball instead of an
/// orange one (report 4.1), all else as GT2003 does.
class GridImageProcessor3 {
 public:
  /// Provides the same percepts as GT2003, under the same conditions.
  void update(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
              const FieldDimensions& field, Percepts found, Random& random, Debug& debug);

 private:
  ImageCorrection correction_;
  GT2003ImageProcessor vision_;
  BlackWhiteBallSpecialist ballSpecialist_;
  BallSpotSpecialist ballSpotSpecialist_;
};

}  // namespace gt
