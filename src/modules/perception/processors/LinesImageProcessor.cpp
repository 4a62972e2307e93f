#include "modules/perception/processors/LinesImageProcessor.h"

#include "modules/perception/scanning/ScanDrawing.h"

namespace gt {

void LinesImageProcessor::update(const Image& image, const CameraMatrix& matrix,
                                 const ColorTable64& colors, const FieldDimensions& field,
                                 Percepts found, Debug& debug) {
  fetch(image);
  found.clear(image.time);
  found.landmarks.cameraOffset = matrix.pose.translation;
  const Horizon horizon = horizonOf(matrix);
  const CameraImage picture{image, colors, matrix, horizon};
  // Only the lines that reach over the whole image.
  grid_.build(image.info, horizon, {.dense = 2, .reachUp = 0, .reachDown = 0});
  scanner_.clear();
  edgeScanner_.clear();
  for (const ScanLine& line : grid_.lines()) {
    scanner_.scan(picture, line, field);
    edgeScanner_.scanDown(picture, line, field);
  }
  for (const ScanLine& row : grid_.rows()) edgeScanner_.scanAcross(picture, row, field);
  for (const GoalIndication& goal : scanner_.goals) edgeScanner_.addGoal(picture, goal);
  edgeScanner_.finish(found.lines);
  drawGrid(grid_, debug);
  drawEdges(edgeScanner_, debug);
}

}  // namespace gt
