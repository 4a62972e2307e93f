#include "match/MatchState.h"

#include <cmath>

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

}  // namespace

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
      if (const auto done = perform(*this, next->line); !done) return done;
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
