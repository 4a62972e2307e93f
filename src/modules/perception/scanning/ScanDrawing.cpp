#include "modules/perception/scanning/ScanDrawing.h"

namespace gt {
namespace {

const DebugKey gridKey{"ImageProcessor/grid"};
const DebugKey edgesKey{"ImageProcessor/edges"};

}  // namespace

Color colorOf(EdgeType type) {
  constexpr EnumArray<EdgeType, Color> edgeColors{
      {colors::white, colors::red, colors::yellow, colors::skyblue}};
  return edgeColors[type];
}

void drawGrid(const ScanGrid& grid, Debug& debug) {
  auto canvas = debug.onImage(gridKey);
  if (!canvas) return;
  for (const auto* lines : {&grid.lines(), &grid.rows()})
    for (const ScanLine& line : *lines)
      canvas.line(line.start, line.at(line.length - 1), colors::gray);
}

void drawEdges(const EdgeScanner& scanner, Debug& debug) {
  auto canvas = debug.onImage(edgesKey);
  if (!canvas) return;
  for (const EdgeScanner::EdgePoint& point : scanner.points())
    canvas.point(point.inImage, colorOf(point.type), 1.5);
}

}  // namespace gt
