#pragma once
#include "modules/perception/Tasks.h"

namespace gt {

/// Storage for the percepts of an image processor, for its caller.
struct FoundPercepts {
  BallPercept ball;
  LandmarksPercept landmarks;
  LinesPercept lines;
  PlayersPercept players;
  ObstaclesPercept obstacles;

  operator Percepts() { return {ball, landmarks, lines, players, obstacles}; }
};

}  // namespace gt
