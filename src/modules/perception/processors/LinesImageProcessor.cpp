#include "modules/perception/processors/LinesImageProcessor.h"

#include "modules/perception/scanning/ScanDrawing.h"

namespace gt {

void LinesImageProcessor::update(const Image& image, const CameraMatrix& matrix,
                                 const ColorTable64& colors, const FieldDimensions& field,
                                 Percepts found, Debug& debug) {
  if (!matrix.valid) return found.clear(image.time);
  const Horizon horizon = horizonOf(matrix);
  const Image& corrected = correction_.correct(image, horizon, colors);
  fetch(corrected);
  found.clear(image.time);
  found.landmarks.cameraOffset = matrix.pose.translation;
  const CameraImage picture{corrected, colors, matrix, horizon};
  // Only the lines that reach over the whole image.
  grid_.build(image.info, horizon, {.dense = 2, .reachUp = 0, .reachDown = 0});
  scan(picture, grid_, field, scanner_, edgeScanner_);
  edgeScanner_.finish(found.lines);
  drawGrid(grid_, debug);
  drawEdges(edgeScanner_, debug);
}

}  // namespace gt
