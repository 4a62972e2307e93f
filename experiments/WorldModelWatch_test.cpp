#include "WorldModelWatch.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

using testing::ElementsAre;

/// A robot of the red team in the middle of the field, with one teammate.
class PlayersMeasures : public testing::Test {
 protected:
  void add(TeamColor team, double x, double y) {
    OracledRobot robot;
    robot.teamColor = team;
    robot.pose.translation = {x, y};
    truth_.others.push_back(robot);
  }
  void knowOpponent(double x, double y) {
    players_.opponents.emplace_back().position = Vector2d{x, y};
  }
  double percent(const std::string& name) {
    Tally tally;
    comparePlayers(players_, TeamColor::red, truth_, tally);
    return tally.rates.at("players." + name).percent();
  }
  OracledWorldState truth_;
  PlayersCollection players_;
};

TEST_F(PlayersMeasures, AReportedOpponentIsNoTeammate) {
  add(TeamColor::red, 1000, 0);
  add(TeamColor::blue, -1000, 0);
  knowOpponent(1000, 0);
  EXPECT_EQ(percent("opponents.true"), 0);
  knowOpponent(-1000, 490);
  EXPECT_EQ(percent("opponents.true"), 50);
  knowOpponent(500, 510);
  EXPECT_NEAR(percent("opponents.true"), 100 / 3., 1e-9);
}

TEST_F(PlayersMeasures, OneReportedOpponentIsOneRobot) {
  add(TeamColor::blue, 1000, 0);
  knowOpponent(1000, 100);
  knowOpponent(1000, -100);
  EXPECT_EQ(percent("opponents.true"), 50);
  players_.opponents.pop_back();
  add(TeamColor::blue, 1000, 300);
  EXPECT_EQ(percent("opponents.known"), 50);
}

/// The first two robots of the red team. The first one saw the ball where it is no more, long ago;
/// the second one sees it.
class TeamBallMeasures : public testing::Test {
 protected:
  TeamBallMeasures() {
    for (Player& player : players_) player.teamColor = TeamColor::red;
    players_[0].role = PlayerRole::striker1;
    players_[1].role = PlayerRole::defender;
    ball_.position = {1000, 0};
    ball_.lastSeen = start_ - 5000;
    pose_.validity = 1;
    message_.playerNumber = players_[1].number();
    message_.timeSent = message_.ballLastSeen = start_;
    message_.robotPoseValidity = 1;
    message_.ballPosition = {0, 0};
  }
  /// The errors of the team's ball some milliseconds after the message was sent.
  double errorAfter(std::int64_t ms, TeamBallWatch& watch, const std::string& name) {
    OracledWorldState truth;
    truth.time = start_ + ms;
    Tally tally;
    watch.update(0, ball_, pose_, truth, tally);
    return tally.errors.at(name).values.at(0);
  }

  static constexpr Time start_{100000};
  std::vector<Player> players_ = std::vector<Player>(2);
  BallModel ball_;
  RobotPose pose_;
  TeamMessage message_;
};

TEST_F(TeamBallMeasures, AMessageIsNotKnownBeforeTheRadioDelivers) {
  RadioParameters radio;
  radio.delayMin = radio.delayMax = 100;
  radio.loss = 0;
  TeamBallWatch watch{"radio", radio, false, players_, Random{1}};
  watch.send(1, message_, start_);
  EXPECT_NEAR(errorAfter(80, watch, "teamball.radio.default"), 1000, 1e-6);
  EXPECT_NEAR(errorAfter(80, watch, "teamball.radio.fused"), 1000, 1e-6);
  EXPECT_NEAR(errorAfter(120, watch, "teamball.radio.default"), 0, 1e-6);
  EXPECT_LT(errorAfter(120, watch, "teamball.radio.fused"), 300);
}

TEST_F(TeamBallMeasures, TheRadioLosesMessages) {
  RadioParameters radio;
  radio.loss = 1;
  TeamBallWatch watch{"radio", radio, false, players_, Random{1}};
  watch.send(1, message_, start_);
  EXPECT_NEAR(errorAfter(500, watch, "teamball.radio.default"), 1000, 1e-6);
}

TEST_F(TeamBallMeasures, ALostRobotReportsTheBallElsewhere) {
  RadioParameters radio;
  radio.loss = 0;
  TeamBallWatch watch{"onelost", radio, true, players_, Random{1}};
  message_.ballPosition = {500, 0};
  watch.send(1, message_, start_);
  // Turned to the left by a right angle, a meter to the left: at (0, 1500).
  EXPECT_NEAR(errorAfter(500, watch, "teamball.onelost.default"), 1500, 1e-6);
}

}  // namespace
}  // namespace gt
