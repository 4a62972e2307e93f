#pragma once
#include "base/Time.h"
#include "representations/behavior/TeamMessage.h"
#include "streams/Reflection.h"

namespace gt {

/// Negotiates with the teammates which field player is the striker and which supporters are
/// offensive and defensive (report 3.8.2). The striker leaves its role to a teammate that has been
/// clearly sooner at the ball for a while, and acts until this one does. Each hand-over has a
/// number, and all follow the highest number that they know. So two robots are never strikers for
/// longer than a message takes, and no break of the radio makes a second one.
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
          field<&P::gone>(Unit::ms,
                          "a teammate is gone if others have been heard for so long without it",
                          {0, 60000}),
          field<&P::silence>(Unit::ms, "a teammate is gone if nobody has been heard for so long",
                             {0, 600000}),
          field<&P::fresh>(Unit::ms,
                           "the ball is left to nobody if nobody has been heard for so long",
                           {0, 60000}),
          field<&P::messageTime>(
              Unit::ms, "from a robot's decision until a teammate follows it, if the radio works",
              {0, 5000}),
          field<&P::strikerAdvantage>(
              Unit::ms, "so much later than a teammate the present striker may reach the ball",
              {0, 60000}),
          field<&P::delay>(Unit::ms,
                           "how long another role has to be the better one until it is taken",
                           {0, 10000}),
          field<&P::forwardAdvantage>(
              Unit::mm, "so far behind others the present offensive supporter may stand",
              {0, 5000})};
    }
  };

  /// A field player that negotiates.
  struct Candidate {
    int number = 0;
    double timeToBall = notAvailable;  ///< ms
    double x = 0;                      ///< mm, on the field
  };
  /// Time to the ball of a player that does not play, in ms.
  static constexpr double notAvailable = 1e6;

  /// The parameters must outlive this.
  explicit RoleNegotiation(const Parameters& parameters) : p_{parameters} {}

  /// Decides by what the teammates sent.
  void update(const Candidate& self, const TeamMessages& team, Time now);

  DynamicRole role() const { return role_; }
  /// What teammates have to know.
  BehaviorTeamMessage message() const { return {role_, self_.timeToBall, striker_, handOver_}; }

 private:
  void adopt(const TeamMessages& team);
  bool isStillNeeded(const TeamMessages& team, Time now) const;
  bool strikerPlays(const TeamMessages& team, Time now) const;
  bool isPresent(const TeamMessages::Received& mate, Time now) const;
  /// The present field player that is at the ball first; not available if there is none.
  Candidate soonestMate(const TeamMessages& team, Time now) const;
  bool isMostForward(const TeamMessages& team, Time now) const;
  void handOverTo(int number, Time now);

  const Parameters& p_;
  Candidate self_;
  Time newest_ = never();  ///< when any teammate was heard last
  int striker_ = 0, handOver_ = 0;
  Time handedOver_ = never();  ///< by this robot
  DynamicRole role_ = DynamicRole::defensiveSupporter;
  /// When it was right last.
  Time strikerRight_ = never(), roleRight_ = never();
};
static_assert(complete<RoleNegotiation::Parameters>);

}  // namespace gt
