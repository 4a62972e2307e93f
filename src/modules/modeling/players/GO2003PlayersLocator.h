#pragma once
#include <vector>

#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/PlayersPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *GO2003* of PlayersLocator: locates other players where the percepts of the last two
/// seconds are dense on a grid, and replaces those of the own team by what the teammates report
/// (report 3.7).
class GO2003PlayersLocator {
 public:
  struct Parameters {
    std::int64_t memory = 2000;
    double cell = 100;
    double spread = 150;
    double threshold = 1.5;
    double playerSize = 350;
    double outside = 300;
    std::int64_t silence = 2000;
    double leastValidity = 0.3;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::memory>(Unit::ms, "time for which a percept is kept", {40, 10000}),
          field<&P::cell>(Unit::mm, "side of a cell of the grid", {20, 1000}),
          field<&P::spread>(Unit::mm,
                            "standard deviation of the distribution of a percept around its cell",
                            {10, 1000}),
          field<&P::threshold>(
              "number of percepts in one place from which on they are a player; old ones count "
              "less",
              {0, 100}),
          field<&P::playerSize>(Unit::mm, "distance below which two players are the same one",
                                {0, 2000}),
          field<&P::outside>(
              Unit::mm, "distance from the field beyond which a percept is no player", {0, 10000}),
          field<&P::silence>(Unit::ms,
                             "time without a message after which a teammate's position is ignored",
                             {0, 100000}),
          field<&P::leastValidity>("least validity of a teammate's pose that is used", {0, 1})};
    }
  };
  Parameters parameters;

  /// Provides the players on the field. Without a new percept known players stay at their positions
  /// until they are forgotten. Teammates are also located by their messages. Percepts count whether
  /// or not the camera matrix was valid.
  void update(const PlayersPercept& percept, const RobotPose& robotPose,
              const TeamMessages& messages, const FieldDimensions& field, const Player& player,
              const FrameInfo& frame, PlayersCollection& players, Debug& debug);

 private:
  struct Sighting {
    Vector2d position = Vector2d::Zero();  ///< mm, on the field.
    Time time;
  };
  /// The percepts of one team in the last two seconds, and how dense they are on the grid.
  struct Team {
    std::vector<Sighting> sightings;
    std::vector<double> density;
  };

  void remember(const std::vector<Vector2d>& seen, Time time, const RobotPose& robotPose,
                const FieldDimensions& field, Team& team) const;
  void distribute(Team& team, Time now);
  void locate(Team& team, Time now, std::vector<LocatedPlayer>& players);
  void setGrid(const FieldDimensions& field);
  double weight(const Sighting& sighting, Time now) const;
  Vector2d cornerOfGrid() const { return {-halfLength_, -halfWidth_}; }

  double halfLength_ = 0, halfWidth_ = 0;  ///< mm, of the grid.
  int columns_ = 0, rows_ = 0;
  EnumArray<TeamColor, Team> teams_;
  std::vector<double> smoothed_, kernel_;
  std::vector<int> maxima_;
  Time lastPercept_ = never();
};

}  // namespace gt
