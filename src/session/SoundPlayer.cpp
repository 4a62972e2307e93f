#include "session/SoundPlayer.h"

namespace gt {
namespace {

/// The state of a robot's loudspeaker; null if none has been received from a remote robot.
const Speaker* speakerOf(Session& session, ConsoleRobot& robot, bool isNew) {
  if (const auto index = robot.index()) return &session.simulation().output(*index).speaker;
  // A robot that cannot be watched plays nothing.
  if (isNew) static_cast<void>(robot.observed().watch("Speaker", {DebugKeyMode::always, 0}));
  return robot.observed().newest<Speaker>();
}

}  // namespace

Result<void> SoundPlayer::follow(Session& session, const std::vector<ConsoleRobot*>& robots) {
  for (ConsoleRobot* robot : robots) {
    const auto [last, isNew] = began_.try_emplace(robot->name(), never());
    const Speaker* speaker = speakerOf(session, *robot, isNew);
    if (!speaker || speaker->began == last->second) continue;
    last->second = speaker->began;
    if (isNew || speaker->sound == Sound::none) continue;
    const std::string file = folder_ + "/" + std::string{enumName(speaker->sound)} + ".wav";
    if (auto done = speaker_.play(file); !done) return done;
  }
  return {};
}

}  // namespace gt
