#pragma once
#include "modules/perception/Tasks.h"

namespace gt {

/// What an image processor finds, for whoever calls one.
struct FoundPercepts {
  BallPercept ball;
  LandmarksPercept landmarks;
  LinesPercept lines;
  PlayersPercept players;
  ObstaclesPercept obstacles;

  operator Percepts() { return {ball, landmarks, lines, players, obstacles}; }
};

}  // namespace gt
