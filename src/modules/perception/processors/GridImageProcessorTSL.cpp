#include "modules/perception/processors/GridImageProcessorTSL.h"

namespace gt {

void GridImageProcessorTSL::update(const Image& image, const CameraMatrix& matrix,
                                   const TslColors& colors, const FieldDimensions& field,
                                   BallPercept& ball, LandmarksPercept& landmarks,
                                   LinesPercept& lines, PlayersPercept& players,
                                   ObstaclesPercept& obstacles, Debug& debug) {
  if (!(colors == known_)) {
    known_ = colors;
    table_ = colors.table();
  }
  vision_.update(image, matrix, table_, field, ball, landmarks, lines, players, obstacles, debug);
}

}  // namespace gt
