#include "match/MatchState.h"

#include <bit>
#include <string_view>
#include <tuple>

#include "match/Match.h"
#include "streams/File.h"
#include "streams/Json.h"

namespace gt {
namespace {

Result<MatchState> readState(const std::string& path) {
  const auto text = readFile(path);
  if (!text) return text.error();
  const auto json = parseJson(*text, path);
  if (!json) return json.error();
  MatchState state;
  if (const auto done = fromJson(*json, state); !done)
    return Error{path, 0, done.error().field, done.error().what};
  if (state.time.ms < 0 || state.time.ms % tickMs != 0)
    return Error{path, 0, "time", "no tick ends then"};
  Time last;
  for (const Intervention& intervention : state.history) {
    if (intervention.time < last || intervention.time > state.time)
      return Error{path, 0, "history", "is not in the order of time"};
    last = intervention.time;
  }
  return state;
}

constexpr std::string_view digits = "0123456789abcdef";

std::string hexOf(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes) {
    text += digits[std::to_integer<std::size_t>(byte >> 4)];
    text += digits[std::to_integer<std::size_t>(byte & std::byte{15})];
  }
  return text;
}

/// What is no digit counts as 0: then the message is none, which is told.
std::vector<std::byte> bytesOf(std::string_view hex) {
  std::vector<std::byte> bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    const auto high = digits.find(hex[i]), low = digits.find(hex[i + 1]);
    bytes.push_back(static_cast<std::byte>((high & 15) << 4 | (low & 15)));
  }
  return bytes;
}

}  // namespace

Result<void> Match::control(std::span<const std::byte> bytes) {
  auto message = parseGameController(bytes);
  if (!message) return message.error();
  // Most messages differ from the last one in the time only, which passes by itself.
  const auto meaning = [](const GameControllerMessage& m) {
    return std::tie(m.state, m.firstHalf, m.kickOff, m.teams.values);
  };
  const bool fresh = !lastControl_ || meaning(*lastControl_) != meaning(*message);
  lastControl_ = *message;
  if (!fresh && simulation_->referee().led()) return {};
  simulation_->referee().follow(*message, simulation_->world());
  note(InterventionKind::gameController, hexOf(bytes));
  return {};
}

void Match::hearGameController() {
  // What no controller sent is ignored, as is what floods in.
  for (int i = 0; i < 10; ++i) {
    const auto bytes = gameController_->receive();
    if (!bytes) return;
    if (control(*bytes)) answerGameController(lastControl_->version);
  }
}

void Match::answerGameController(int version) const {
  const std::vector<Player>& players = simulation_->players();
  for (std::size_t i = 0; i < allRobots_.size(); ++i) {
    GameControllerAnswer answer;
    answer.team = lastControl_->teams[players[i].teamColor].number;
    answer.player = players[i].number();
    answer.fallen = simulation_->world().robot(i).posture != Posture::standing;
    const MatchRobot& robot = *allRobots_[i];
    if (robot.pose()) answer.pose = robot.pose()->pose;
    if (robot.ball() && robot.ball()->lastSeen != never()) {
      answer.ballAge = static_cast<double>(time() - robot.ball()->lastSeen) / 1000;
      answer.ball = robot.ball()->position;
    }
    gameController_->answer(answerBytes(answer, version), gameControllerAnswerPort(version));
  }
}

void Match::note(InterventionKind kind, std::string line) {
  history_.push_back({time(), kind, std::move(line)});
}

void Match::spoil(const std::string& why) {
  if (spoiled_.empty()) spoiled_ = why;
}

std::uint64_t Match::fingerprint() const {
  std::uint64_t sum = simulation_->fingerprint();
  for (const MatchRobot* robot : allRobots_)
    for (const double number : {robot->pose() ? robot->pose()->pose.translation.x() : 0,
                                robot->pose() ? robot->pose()->pose.translation.y() : 0,
                                robot->ball() ? robot->ball()->position.x() : 0})
      sum = (sum ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3;
  return sum;
}

Result<void> Match::save(const std::string& path) const {
  if (!spoiled_.empty()) return Error{path, 0, "", "this match cannot be repeated: " + spoiled_};
  const MatchState state{options_.scene,   options_.layout,  options_.behavior,
                         options_.motions, options_.minutes, options_.seed,
                         time(),           history_,         fingerprint()};
  return writeFile(path, toJson(state).dump(1) + "\n");
}

Result<std::unique_ptr<Match>> Match::load(const std::string& path, MatchOptions options,
                                           const Perform& perform) {
  const auto state = readState(path);
  if (!state) return state.error();
  options.scene = state->scene;
  options.layout = state->layout;
  options.behavior = state->behavior;
  options.motions = state->motions;
  options.minutes = state->minutes;
  options.seed = state->seed;
  options.remote.clear();
  auto match = make(options);
  if (!match) return match.error();
  if (const auto done = (*match)->repeat(*state, perform); !done)
    return Error{path, 0, done.error().field, done.error().text()};
  if ((*match)->fingerprint() != state->fingerprint)
    return Error{path, 0, "fingerprint",
                 "the match went another way: its files or the program have changed"};
  return match;
}

Result<void> Match::repeat(const MatchState& state, const Perform& perform) {
  auto next = state.history.begin();
  while (true) {
    for (; next != state.history.end() && next->time == time(); ++next) {
      const auto done = next->kind == InterventionKind::gameController
                            ? control(bytesOf(next->line))
                            : perform(*this, next->line);
      if (!done) return done;
    }
    if (time() >= state.time) break;
    if (finished()) return Error{"", 0, "time", "the match is over before"};
    step();
  }
  history_ = state.history;
  if (next != state.history.end()) return Error{"", 0, "history", "something between two ticks"};
  return {};
}

}  // namespace gt
