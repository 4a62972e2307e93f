#pragma once
#include <Eigen/Core>
#include <vector>

#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/PlayersPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Tracks* of PlayersLocator: a Kalman filter for each player that the robot sees, and
/// the opponents of the whole team, which all robots report to each other. In the report (3.7) each
/// robot knows the opponents alone that it has seen within two seconds.
class TrackingPlayersLocator {
 public:
  struct Parameters {
    std::int64_t memory = 6000;
    double walk = 130;
    double alongShare = 0.2;
    double acrossShare = 0.06;
    double leastNoise = 60;
    double farthest = 2500;
    double gate = 2.5;
    double playerSize = 350;
    double outside = 300;
    double seen = 0.5;
    double missed = 0.7;
    double known = 0.7;
    double missedRange = 1500;
    double poseNoise = 60;
    std::int64_t silence = 2000;
    double leastValidity = 0.3;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::memory>(Unit::ms, "time after which a player not seen again is forgotten",
                            {40, 60000}),
          field<&P::walk>(
              Unit::mm,
              "standard deviation of how far a player walks within a second, and by its root in "
              "longer times",
              {0, 1000}),
          field<&P::alongShare>("standard deviation of a percept's distance, as a share of it",
                                {0, 1}),
          field<&P::acrossShare>(
              "standard deviation of a percept across the line of sight, as a share of the "
              "distance",
              {0, 1}),
          field<&P::leastNoise>(Unit::mm, "what both have at least", {1, 1000}),
          field<&P::farthest>(Unit::mm, "distance up to which percepts count", {0, 10000}),
          field<&P::gate>("standard deviations up to which a percept is that of a known player",
                          {0.1, 10}),
          field<&P::playerSize>(Unit::mm, "distance below which two players are the same one",
                                {0, 2000}),
          field<&P::outside>(Unit::mm,
                             "distance outside of the field from which on a percept is no player",
                             {0, 10000}),
          field<&P::seen>("share of the doubt in a player that a percept takes away", {0, 1}),
          field<&P::missed>("factor to the certainty of a player that should be seen and is not",
                            {0, 1}),
          field<&P::known>("certainty from which on a player counts", {0, 1}),
          field<&P::missedRange>(
              Unit::mm, "distance up to which a player in the image is expected to be seen",
              {0, 10000}),
          field<&P::poseNoise>(Unit::mm,
                               "standard deviation of where a teammate's pose puts what it sees",
                               {0, 1000}),
          field<&P::silence>(Unit::ms, "time after which a teammate's message is too old",
                             {0, 100000}),
          field<&P::leastValidity>("least validity of a teammate's pose that is believed", {0, 1})};
    }
  };
  Parameters parameters;

  /// Provides the players on the field. Without a new percept those known become less certain with
  /// time. Percepts count whether or not the camera matrix is valid; that a player is not seen
  /// counts with a valid one only.
  void update(const PlayersPercept& percept, const CameraMatrix& camera, const RobotPose& robotPose,
              const TeamMessages& messages, const FieldDimensions& field, const Player& player,
              const FrameInfo& frame, PlayersCollection& players, Debug& debug);

 private:
  /// A player as the own percepts have it, on the field.
  struct Track {
    Vector2d position;           ///< mm
    Eigen::Matrix2d covariance;  ///< mm^2
    Time lastSeen;
    double certainty = 0;  ///< That it exists, from 0 to 1.
    bool matched = false;  ///< By a percept of this image.
  };
  /// An opponent as one robot reports it.
  struct Report {
    Vector2d position;  ///< mm, on the field
    double variance;    ///< mm^2
    Time lastSeen;      ///< by the own clock
    double certainty;
    std::size_t robot;  ///< Index of its message; of the robot itself one more than there are.
    bool merged = false;
  };
  using Tracks = std::vector<Track>;

  void predict(Tracks& tracks, Time now, double seconds) const;
  void observe(const std::vector<Vector2d>& seen, Time time, const RobotPose& robotPose,
               const FieldDimensions& field, Tracks& tracks) const;
  void miss(const CameraMatrix& camera, const RobotPose& robotPose, Tracks& tracks) const;
  void collect(const std::vector<LocatedPlayer>& own, const TeamMessages& messages,
               const Player& player, Time now);
  void merge(std::vector<LocatedPlayer>& players);

  EnumArray<TeamColor, Tracks> tracks_;
  std::vector<Report> reports_;
  Time lastPercept_ = never(), lastUpdate_ = never();
};

}  // namespace gt
