#pragma once
#include <tuple>

#include "representations/perception/BallPercept.h"
#include "representations/perception/BodyPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LearnedCalibration.h"
#include "representations/perception/LinesPercept.h"
#include "representations/perception/ObstaclesPercept.h"
#include "representations/perception/PlayersPercept.h"
#include "representations/perception/PsdPercept.h"

namespace gt {

/// The task of interpreting the body's sensors (report 3.1).
struct SensorDataProcessor {
  using Outputs = std::tuple<CameraMatrix, BodyPercept, PsdPercept, LearnedCalibration>;
};

/// The task of finding things in an image (report 3.2). Percepts are places relative to the robot.
/// An image without a valid camera matrix, as during kicks and falls, yields no percept except a
/// ball, whose size gives its distance (3.2.3).
struct ImageProcessor {
  using Outputs =
      std::tuple<BallPercept, LandmarksPercept, LinesPercept, PlayersPercept, ObstaclesPercept>;
};

/// All outputs of a solution of ImageProcessor, as one parameter of its update().
struct Percepts {
  BallPercept& ball;
  LandmarksPercept& landmarks;
  LinesPercept& lines;
  PlayersPercept& players;
  ObstaclesPercept& obstacles;

  using Parts = std::tuple<BallPercept&, LandmarksPercept&, LinesPercept&, PlayersPercept&,
                           ObstaclesPercept&>;

  /// Sets the percepts to those of an image, taken at `time`, that shows nothing.
  void clear(Time time) const {
    ball = {};
    landmarks.numberOfFlags = landmarks.numberOfGoals = 0;
    for (auto& points : lines.points) points.clear();
    for (auto& places : players.players) places.clear();
    obstacles.lines.clear();
    setTime(time);
  }
  void setTime(Time time) const {
    ball.time = landmarks.time = lines.time = players.time = obstacles.time = time;
  }
};

using PerceptionTasks = std::tuple<SensorDataProcessor, ImageProcessor>;

}  // namespace gt
