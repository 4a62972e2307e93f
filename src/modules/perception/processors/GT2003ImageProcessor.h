#pragma once
#include "debug/Debug.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/scanning/EdgeScanner.h"
#include "modules/perception/scanning/LineScanner.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "modules/perception/specialists/BallSpecialist.h"
#include "modules/perception/specialists/FlagSpecialist.h"
#include "modules/perception/specialists/GoalSpecialist.h"
#include "modules/perception/specialists/PlayerSpecialist.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// Finds ball, flags, goals, edges, robots and free ground on a horizon-aligned grid with a colour
/// table (report 3.2), the solution GT2003 of the ImageProcessor.
class GT2003ImageProcessor {
 public:
  struct Parameters {
    double denseSpacing = 2;

    static constexpr auto fields() {
      return Fields{field("denseSpacing", &Parameters::denseSpacing, "pixel",
                          "between scan lines next to the horizon", {1, 16})};
    }
  };
  Parameters parameters;

  void update(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
              const FieldDimensions& field, BallPercept& ball, LandmarksPercept& landmarks,
              LinesPercept& lines, PlayersPercept& players, ObstaclesPercept& obstacles,
              Debug& debug);

 private:
  GridSpacing spacing(const CameraMatrix& matrix, const FieldDimensions& field) const;
  void findFreeGround(const Picture& picture, ObstaclesPercept& percept) const;
  void drawScan(const Picture& picture, Debug& debug) const;
  void drawSpecialists(Debug& debug) const;
  void drawPercepts(const Picture& picture, const BallPercept& ball,
                    const LandmarksPercept& landmarks, const PlayersPercept& players,
                    Debug& debug) const;
  void drawGround(const BallPercept& ball, const LinesPercept& lines, const PlayersPercept& players,
                  const ObstaclesPercept& obstacles, Debug& debug) const;

  ScanGrid grid_;
  LineScanner scanner_;
  BallSpecialist ballSpecialist_;
  FlagSpecialist flagSpecialist_;
  GoalSpecialist goalSpecialist_;
  EdgeScanner edgeScanner_;
  PlayerSpecialist playerSpecialist_;
  std::vector<ScanWay> ways_;  ///< Of the specialists, if somebody wants to see them.
};

}  // namespace gt
