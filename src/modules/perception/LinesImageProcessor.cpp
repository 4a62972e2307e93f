#include "modules/perception/LinesImageProcessor.h"

namespace gt {
namespace {

const DebugKey drawGrid{"ImageProcessor/grid"};
const DebugKey drawEdges{"ImageProcessor/edges"};

}  // namespace

void LinesImageProcessor::update(const Image& image, const CameraMatrix& matrix,
                                 const ColorTable64& colors, const FieldDimensions& field,
                                 BallPercept& ball, LandmarksPercept& landmarks,
                                 LinesPercept& lines, PlayersPercept& players,
                                 ObstaclesPercept& obstacles, Debug& debug) {
  ball = {};
  landmarks.numberOfFlags = landmarks.numberOfGoals = 0;
  landmarks.cameraOffset = matrix.pose.translation;
  for (auto& list : players.players) list.clear();
  obstacles.lines.clear();

  const Horizon horizon = horizonOf(matrix);
  const Picture picture{image, colors, matrix, horizon};
  // Only the lines that reach over the whole picture.
  grid_.build(image.info, horizon, {.dense = 2, .reachUp = 0, .reachDown = 0});
  scanner_.clear();
  edgeScanner_.clear();
  for (const ScanLine& line : grid_.lines()) {
    scanner_.scan(picture, line, field);
    edgeScanner_.scanDown(picture, line, field);
  }
  for (const ScanLine& row : grid_.rows()) edgeScanner_.scanAcross(picture, row, field);
  for (const GoalIndication& goal : scanner_.goals) edgeScanner_.addGoal(picture, goal);
  edgeScanner_.finish(lines);
  ball.time = landmarks.time = lines.time = players.time = obstacles.time = image.time;

  if (auto canvas = debug.onImage(drawGrid))
    for (const auto* group : {&grid_.lines(), &grid_.rows()})
      for (const ScanLine& line : *group)
        canvas.line(line.start, line.at(line.length - 1), colors::gray);
  if (auto canvas = debug.onImage(drawEdges)) {
    constexpr EnumArray<EdgeType, Color> edgeColors{
        {colors::white, colors::red, colors::yellow, colors::skyblue}};
    for (const EdgeScanner::EdgePoint& point : edgeScanner_.points())
      canvas.point(point.inPicture, edgeColors[point.type], 1.5);
  }
}

}  // namespace gt
