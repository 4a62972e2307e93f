#pragma once
#include <functional>
#include <span>
#include <vector>

#include "debug/Debug.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/colors/ImageCorrection.h"
#include "modules/perception/scanning/EdgeScanner.h"
#include "modules/perception/scanning/IndicationScanner.h"
#include "modules/perception/scanning/ScanGrid.h"
#include "modules/perception/specialists/BallSpecialist.h"
#include "modules/perception/specialists/FlagSpecialist.h"
#include "modules/perception/specialists/GoalSpecialist.h"
#include "modules/perception/specialists/PlayerSpecialist.h"
#include "modules/perception/specialists/TiltCorrection.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// Solution *GT2003* of ImageProcessor: finds ball, flags, goals, edges, robots and free ground on
/// a horizon-aligned grid with a color table (report 3.2).
class GT2003ImageProcessor {
 public:
  struct Parameters {
    double denseSpacing = 2;

    static constexpr auto fields() {
      return Fields{field<&Parameters::denseSpacing>(
          Unit::pixel, "distance of scan lines next to the horizon", {1, 16})};
    }
  };
  Parameters parameters;

  /// Provides all percepts of an image, relative to the robot. Without a valid camera matrix only
  /// the ball is provided, because its size gives its distance. An image without pixels yields no
  /// percepts.
  void update(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
              const FieldDimensions& field, Percepts found, Debug& debug) {
    lookForAll(correction_.correct(image, horizonOf(matrix), colors), matrix, colors, field, found,
               debug);
  }

  /// Like update, on an image whose colors are corrected already.
  void lookForAll(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
                  const FieldDimensions& field, const Percepts& found, Debug& debug) {
    const auto findBall = [&](const CameraImage& picture, std::span<const BallSegment> segments) {
      ballSpecialist_.find(picture, segments, field.ballRadius, found.ball);
    };
    look(image, matrix, colors, field, found, debug, std::cref(findBall));
  }

  /// Passed as std::cref, so that nothing is allocated.
  using FindBall = std::function<void(const CameraImage&, std::span<const BallSegment>)>;

  /// Like lookForAll, with another function that finds the ball.
  void look(const Image& image, const CameraMatrix& matrix, const ColorTable64& colors,
            const FieldDimensions& field, const Percepts& found, Debug& debug,
            const FindBall& findBall);

 private:
  GridSpacing spacing(const CameraMatrix& matrix, const FieldDimensions& field) const;
  /// Finds all but the ball.
  void findPlaces(const CameraImage& picture, const FieldDimensions& field, const Percepts& found);
  void findFreeGround(const CameraImage& picture, ObstaclesPercept& percept) const;
  void drawScan(const CameraImage& picture, Debug& debug) const;
  void drawSpecialists(bool hasPlaces, Debug& debug) const;
  void drawPercepts(const CameraImage& picture, const Percepts& found, Debug& debug) const;
  void drawGround(const Percepts& found, Debug& debug) const;

  ImageCorrection correction_;
  ScanGrid grid_;
  IndicationScanner scanner_;
  BallSpecialist ballSpecialist_;
  FlagSpecialist flagSpecialist_;
  GoalSpecialist goalSpecialist_;
  EdgeScanner edgeScanner_;
  PlayerSpecialist playerSpecialist_;
  TiltCorrection tiltCorrection_;
  /// Paths that the specialists followed, if a drawing of them is requested.
  std::vector<ScanPath> paths_;
};

}  // namespace gt
