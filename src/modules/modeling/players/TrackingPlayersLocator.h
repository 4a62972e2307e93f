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

/// Solution *Tracks* of PlayersLocator: tracks each player that the robot sees by a Kalman filter,
/// and merges the opponents that all robots of the team report to each other. In the report (3.7) a
/// robot only knows the opponents that it has seen itself within two seconds.
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
              "standard deviation of a player's displacement in a second; grows with the square "
              "root of time",
              {0, 1000}),
          field<&P::alongShare>(
              "standard deviation of a percept's distance, as a share of the distance", {0, 1}),
          field<&P::acrossShare>(
              "standard deviation of a percept across the line of sight, as a share of the "
              "distance",
              {0, 1}),
          field<&P::leastNoise>(
              Unit::mm, "least standard deviation of a percept along and across the line of sight",
              {1, 1000}),
          field<&P::farthest>(Unit::mm, "distance up to which percepts count", {0, 10000}),
          field<&P::gate>(
              "greatest difference, in standard deviations, of a percept and the player that it is "
              "assigned to",
              {0.1, 10}),
          field<&P::playerSize>(Unit::mm, "distance below which two players are the same one",
                                {0, 2000}),
          field<&P::outside>(
              Unit::mm, "distance from the field beyond which a percept is no player", {0, 10000}),
          field<&P::seen>("share of the uncertainty of a player's existence that a percept removes",
                          {0, 1}),
          field<&P::missed>("factor to the certainty of a player that should be seen and is not",
                            {0, 1}),
          field<&P::known>("certainty from which on a player counts", {0, 1}),
          field<&P::missedRange>(
              Unit::mm, "distance up to which a player in the image is expected to be seen",
              {0, 10000}),
          field<&P::poseNoise>(
              Unit::mm,
              "standard deviation that a teammate's pose adds to the opponents that it reports",
              {0, 1000}),
          field<&P::silence>(Unit::ms, "time after which a teammate's message is too old",
                             {0, 100000}),
          field<&P::leastValidity>("least validity of a teammate's pose that is used", {0, 1})};
    }
  };
  Parameters parameters;

  /// Provides the players on the field. Without a new percept the positions of known players become
  /// less certain with time. Percepts count whether or not the camera matrix is valid. That a
  /// player is not seen counts only with a valid matrix.
  void update(const PlayersPercept& percept, const CameraMatrix& camera, const RobotPose& robotPose,
              const TeamMessages& messages, const FieldDimensions& field, const Player& player,
              const FrameInfo& frame, PlayersCollection& players, Debug& debug);

 private:
  /// A player on the field, tracked by the robot's own percepts.
  struct Track {
    Vector2d position;           ///< mm
    Eigen::Matrix2d covariance;  ///< mm^2
    Time lastSeen;
    double certainty = 0;  ///< Probability that it exists, from 0 to 1.
    bool matched = false;  ///< Whether a percept of this image was assigned to it.
  };
  /// An opponent as one robot reports it.
  struct Report {
    Vector2d position;  ///< mm, on the field
    double variance;    ///< mm^2
    Time lastSeen;      ///< by the robot's own clock
    double certainty;
    /// Index of the sender's message; the robot itself has the index after the last message.
    std::size_t robot;
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
