#pragma once
#include "debug/Debug.h"
#include "modules/perception/scanning/EdgeScanner.h"
#include "modules/perception/scanning/ScanGrid.h"

namespace gt {

/// The color in which edges of a type are drawn.
Color colorOf(EdgeType type);
/// Draws all lines of the grid under the key `ImageProcessor/grid`.
void drawGrid(const ScanGrid& grid, Debug& debug);
/// Draws all points on edges under the key `ImageProcessor/edges`.
void drawEdges(const EdgeScanner& scanner, Debug& debug);

}  // namespace gt
