#include "modules/perception/processors/GridImageProcessorTSL.h"

namespace gt {

void GridImageProcessorTSL::update(const Image& image, const CameraMatrix& matrix,
                                   const TslColors& colors, const FieldDimensions& field,
                                   Percepts found, Debug& debug) {
  if (!(colors == known_)) {
    known_ = colors;
    table_ = colors.table();
  }
  vision_.lookForAll(image, matrix, table_, field, found, debug);
}

}  // namespace gt
