#include <algorithm>

#include "console/Commands.h"

namespace gt {
namespace {

/// Sends remote robots the data that a game manager would send them.
Result<void> sendElsewhere(Console& console, GameState state, std::optional<TeamColor> kickOff,
                           std::array<int, 2> score) {
  for (const auto& known : console.session().robots()) {
    if (known->index()) continue;
    const auto player = known->observed().value<Player>();
    if (!player) return player.error();
    const TeamColor team = (*player)->teamColor;
    GameControlData data;
    data.state = state;
    if (kickOff) data.kickOff = *kickOff == team ? KickOff::own : KickOff::opponent;
    data.ownScore = score[static_cast<std::size_t>(team)];
    data.opponentScore = score[static_cast<std::size_t>(opponent(team))];
    if (auto done = known->observed().send(data); !done) return done;
  }
  return {};
}

Result<void> gc(Console& console, const Words& words) {
  const std::string& what = words[1];
  Referee& referee = console.session().simulation().referee();
  const Time now = console.session().time();
  std::array<int, 2> score{referee.score(TeamColor::red), referee.score(TeamColor::blue)};
  std::optional<TeamColor> kickOff;
  GameState state = referee.state();
  if (what == "kickOff") {
    kickOff = enumValue<TeamColor>(words[2]);
    for (std::size_t i = 3; i < words.size(); ++i) {  // blue, then red
      const auto goals = numberOf(words[i], 0, 1000);
      if (!goals) return goals.error();
      score[4 - i] = static_cast<int>(*goals);
    }
    referee.setKickOff(*kickOff);
    state = GameState::set;
  } else if (what == "reset") {
    score = {0, 0};
    state = GameState::initial;
  } else if (what == "ready") {
    state = GameState::ready;
  } else {
    state = what == "playing" ? GameState::playing : GameState::finished;
  }
  referee.setScore(TeamColor::red, score[0], now);
  referee.setScore(TeamColor::blue, score[1], now);
  referee.order(state, console.session().simulation().world());
  if (state == GameState::ready)  // report J.2.6
    for (std::size_t i = 0; i < console.session().simulation().world().activeRobots(); ++i)
      referee.setPenalty(i, Penalty::none, now);
  return sendElsewhere(console, state, kickOff, score);
}

/// The report's names of penalties, of the rules of 2003.
constexpr std::pair<std::string_view, Penalty> penalties[] = {
    {"continue", Penalty::none},
    {"illegalDefender", Penalty::illegalDefender},
    {"obstruction", Penalty::obstruction},
    {"keeperCharged", Penalty::keeperCharge},
    {"ballHolding", Penalty::ballHolding},
    {"fieldPlayerCharged", Penalty::fieldPlayerCharge},
    {"illegalDefense", Penalty::illegalDefense},
    {"requestForPickup", Penalty::requestForPickup}};

Result<void> pr(Console& console, const Words& words) {
  const auto known =
      std::ranges::find_if(penalties, [&](const auto& p) { return p.first == words[1]; });
  const Penalty penalty = known->second;
  Session& session = console.session();
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    if (robot.index()) {
      session.simulation().referee().setPenalty(*robot.index(), penalty, session.time());
      return {};
    }
    GameControlData data;
    data.state = penalty == Penalty::none ? GameState::playing : GameState::penalized;
    data.penalty = penalty;
    return robot.observed().send(data);
  });
}

Result<void> gs(Console& console, const Words& words) {
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    return robot.observed().set("WalkingEngine.InvKin.gameSpeed", words[1]);
  });
}

}  // namespace

std::vector<Command> gameCommands() {
  using enum Command::Kind;
  return {
      {global, "gc", "reset | ready | playing | final | kickOff (blue | red) [BLUESCORE REDSCORE]",
       "Controls the game of all robots, as a game manager does; reset also clears the score, "
       "ready "
       "lifts all penalties.",
       gc, nullptr, true},
      {robot, "gs", "FACTOR",
       "Sets the game speed (report J.2.6): all requested speeds ahead and sideways are multiplied "
       "by the factor, 0.1 to 1.",
       gs, nullptr, true},
      {robot, "pr",
       "continue | illegalDefender | obstruction | keeperCharged | ballHolding | "
       "fieldPlayerCharged | illegalDefense | requestForPickup",
       "Penalizes robots, or ends their penalties.", pr, nullptr, true}};
}

}  // namespace gt
