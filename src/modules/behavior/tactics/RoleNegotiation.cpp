#include "modules/behavior/tactics/RoleNegotiation.h"

#include <algorithm>

namespace gt {

void RoleNegotiation::update(const Candidate& self, const TeamMessages& team, Time now) {
  const bool begins = self_.number == 0;
  self_ = self;
  for (const TeamMessages::Received& mate : team.byPlayer)
    newest_ = std::max(newest_, mate.timeReceived);
  adopt(team);

  const Candidate mate = soonestMate(team, now);
  const bool isStriker = striker_ == self.number, plays = strikerPlays(team, now);
  const bool leaves = isStriker && mate.timeToBall + p_.strikerAdvantage < self.timeToBall &&
                      static_cast<double>(now - newest_) < p_.fresh;
  if (plays && !leaves) strikerRight_ = now;
  const bool isDue = static_cast<double>(now - strikerRight_) >= p_.delay;
  if (isStriker && (!plays || (leaves && isDue)))
    handOverTo(mate.number, now);
  else if (!isStriker && !plays && (begins || isDue) && self.timeToBall < notAvailable &&
           self.timeToBall <= mate.timeToBall)
    handOverTo(self.number, now);

  const DynamicRole supporter =
      isMostForward(team, now) ? DynamicRole::offensiveSupporter : DynamicRole::defensiveSupporter;
  const bool acts = striker_ == self.number || isStillNeeded(team, now);
  const DynamicRole wanted = acts ? DynamicRole::striker : supporter;
  if (wanted == role_) roleRight_ = now;
  const bool atOnce = begins || wanted == DynamicRole::striker || role_ == DynamicRole::striker;
  if (atOnce || static_cast<double>(now - roleRight_) >= p_.delay) role_ = wanted;
}

/// If two robots have decided with the same hand-over number, the robot with the lower player
/// number is the striker.
void RoleNegotiation::adopt(const TeamMessages& team) {
  for (const TeamMessages::Received& mate : team.byPlayer) {
    const BehaviorTeamMessage& told = mate.message.behavior;
    if (mate.message.playerNumber <= 1 || mate.message.playerNumber == self_.number) continue;
    const bool isNewer = told.handOver > handOver_;
    const bool isAsNew = told.handOver == handOver_ && told.striker != 0;
    if (!isNewer && !(isAsNew && (striker_ == 0 || told.striker < striker_))) continue;
    striker_ = told.striker;
    handOver_ = told.handOver;
  }
}

/// A striker that has handed its role over acts until it hears that the new one acts, or, if the
/// radio works, until the new one must have received the message.
bool RoleNegotiation::isStillNeeded(const TeamMessages& team, Time now) const {
  if (role_ != DynamicRole::striker || self_.timeToBall >= notAvailable || striker_ == 0)
    return false;
  const BehaviorTeamMessage& told =
      team.byPlayer[static_cast<std::size_t>(striker_ - 1)].message.behavior;
  const bool acts = told.role == DynamicRole::striker && told.handOver >= handOver_;
  const bool mayHaveHeard = static_cast<double>(now - handedOver_) >= p_.messageTime &&
                            static_cast<double>(now - newest_) < p_.messageTime;
  return !acts && !mayHaveHeard;
}

bool RoleNegotiation::strikerPlays(const TeamMessages& team, Time now) const {
  if (striker_ == self_.number) return self_.timeToBall < notAvailable;
  return striker_ != 0 && isPresent(team.byPlayer[static_cast<std::size_t>(striker_ - 1)], now);
}

/// The network may break down for seconds in which nobody is heard. A robot that is not heard while
/// others are is absent. A robot that does not play is treated as absent.
bool RoleNegotiation::isPresent(const TeamMessages::Received& mate, Time now) const {
  return mate.message.playerNumber > 1 && mate.message.playerNumber != self_.number &&
         mate.message.behavior.estimatedTimeToReachBall < notAvailable &&
         static_cast<double>(newest_ - mate.timeReceived) < p_.gone &&
         static_cast<double>(now - mate.timeReceived) < p_.silence;
}

RoleNegotiation::Candidate RoleNegotiation::soonestMate(const TeamMessages& team, Time now) const {
  Candidate soonest;
  for (const TeamMessages::Received& mate : team.byPlayer)
    if (isPresent(mate, now) && mate.message.behavior.estimatedTimeToReachBall < soonest.timeToBall)
      soonest = {mate.message.playerNumber, mate.message.behavior.estimatedTimeToReachBall,
                 mate.message.robotPose.translation.x()};
  return soonest;
}

bool RoleNegotiation::isMostForward(const TeamMessages& team, Time now) const {
  const double ahead = role_ == DynamicRole::offensiveSupporter ? p_.forwardAdvantage : 0;
  return std::ranges::none_of(team.byPlayer, [&](const TeamMessages::Received& mate) {
    return isPresent(mate, now) && mate.message.playerNumber != striker_ &&
           mate.message.robotPose.translation.x() > self_.x + ahead;
  });
}

void RoleNegotiation::handOverTo(int number, Time now) {
  striker_ = number;
  handedOver_ = now;
  ++handOver_;
}

}  // namespace gt
