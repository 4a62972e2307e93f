#pragma once
#include "base/Time.h"
#include "representations/behavior/TeamMessage.h"
#include "streams/Reflection.h"

namespace gt {

/// Negotiates with the teammates which field player is the striker and which supporters are
/// offensive and defensive (report 3.8.2). The striker hands its role over to a teammate that could
/// have reached the ball clearly sooner for a while, and acts until that one does. Each hand-over
/// has a number, and all robots follow the highest number that they know. Therefore two robots are
/// never strikers for longer than a message takes, and a break of the radio does not create a
/// second one.
class RoleNegotiation {
 public:
  struct Parameters {
    double gone = 3000;
    double silence = 30000;
    double fresh = 500;
    double messageTime = 180;
    double strikerAdvantage = 1500;
    double delay = 1200;
    double forwardAdvantage = 300;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::gone>(
              Unit::ms,
              "time without a message of a teammate, while others are heard, after which it is "
              "absent",
              {0, 60000}),
          field<&P::silence>(
              Unit::ms, "time without a message of a teammate after which it is absent in any case",
              {0, 600000}),
          field<&P::fresh>(
              Unit::ms,
              "time without any message after which the striker does not hand its role over",
              {0, 60000}),
          field<&P::messageTime>(
              Unit::ms,
              "time from a robot's decision until a teammate follows it, if the radio works",
              {0, 5000}),
          field<&P::strikerAdvantage>(
              Unit::ms,
              "time by which the present striker may reach the ball later than a teammate and keep "
              "its role",
              {0, 60000}),
          field<&P::delay>(Unit::ms,
                           "time for which another role must be the better one until it is taken",
                           {0, 10000}),
          field<&P::forwardAdvantage>(
              Unit::mm,
              "distance by which the present offensive supporter may stand behind others and keep "
              "its role",
              {0, 5000})};
    }
  };

  /// A field player that negotiates.
  struct Candidate {
    int number = 0;
    double timeToBall = notAvailable;  ///< ms
    double x = 0;                      ///< mm, on the field
  };
  /// The time to the ball (ms) that a player sends if it does not play.
  static constexpr double notAvailable = 1e6;

  /// The parameters must outlive this.
  explicit RoleNegotiation(const Parameters& parameters) : p_{parameters} {}

  /// Decides by the messages of the teammates.
  void update(const Candidate& self, const TeamMessages& team, Time now);

  DynamicRole role() const { return role_; }
  /// The message to the teammates.
  BehaviorTeamMessage message() const { return {role_, self_.timeToBall, striker_, handOver_}; }

 private:
  void adopt(const TeamMessages& team);
  bool isStillNeeded(const TeamMessages& team, Time now) const;
  bool strikerPlays(const TeamMessages& team, Time now) const;
  bool isPresent(const TeamMessages::Received& mate, Time now) const;
  /// The present teammate, of the field players, with the least time to the ball; its time is
  /// notAvailable if there is none.
  Candidate soonestMate(const TeamMessages& team, Time now) const;
  bool isMostForward(const TeamMessages& team, Time now) const;
  void handOverTo(int number, Time now);

  const Parameters& p_;
  Candidate self_;
  Time newest_ = never();  ///< time of the last message of any teammate
  int striker_ = 0, handOver_ = 0;
  Time handedOver_ = never();  ///< time of the last hand-over by this robot
  DynamicRole role_ = DynamicRole::defensiveSupporter;
  /// The last time at which striker and role were right.
  Time strikerRight_ = never(), roleRight_ = never();
};
static_assert(complete<RoleNegotiation::Parameters>);

}  // namespace gt
