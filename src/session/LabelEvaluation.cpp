#include "session/LabelEvaluation.h"

#include <algorithm>
#include <memory>

#include "logs/LogPlayer.h"
#include "logs/RobotLog.h"
#include "streams/MessageDefinition.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// Copies a value that a robot provides; does nothing if it does not.
template <typename T>
void copyProvided(const Robot& robot, T& value) {
  if (const T* provided = robot.provided<T>()) value = *provided;
}

}  // namespace

Result<std::vector<LoggedImage>> imagesOf(const std::string& log,
                                          const std::function<bool(double share)>& progress) {
  auto player = LogPlayer::open(log);
  if (!player) return player.error();
  std::vector<LoggedImage> images;
  const std::string topic = inputTopic + std::string{representation<Image>().name};
  Image image;
  const auto read = [&](const McapChannel& channel, const McapMessage& message) -> Result<void> {
    if (channel.topic != topic) return {};
    if (channel.schemaText == representation<Image>().schema().text) {
      if (auto done = decode(message.data, image); !done) return done;
    } else {
      const auto definition = MessageDefinition::parse(channel.schemaName, channel.schemaText);
      if (!definition) return definition.error();
      if (auto done = readRecorded(*definition, message.data, image); !done) return done;
    }
    images.push_back({Time{static_cast<std::int64_t>(message.time / 1'000'000)}, image.time,
                      player->position() - 1});
    return {};
  };
  const auto length = static_cast<double>(std::max<std::size_t>(1, player->moments().size()));
  while (progress(static_cast<double>(player->position()) / length)) {
    const auto more = player->next(read);
    if (!more) return more.error();
    if (!*more) break;
  }
  return images;
}

Result<std::vector<LabelError>> compareWithLabels(
    const ComparedRun& run, const ImageLabels& labels, const LogRobotOptions& options,
    const std::function<bool(double share)>& progress) {
  std::vector<Configuration::SolutionChoice> solutions;
  if (!run.task.empty()) solutions.push_back({run.task, run.solution, "", 0});
  auto log = openLog(run.log, options, solutions);
  if (!log) return log.error();
  ReplayPlatform& platform = log->platform;
  if (const std::string missing = platform.missingFor("ImageProcessor"); !missing.empty())
    return Error{.file = run.log, .what = missing};
  int picture = -1;
  bool taken = false;
  SeenInImage seen;
  platform.onInput([&](Time, const RepresentationType& type, const void* package) {
    if (&type == &representation<CameraMatrix>())
      seen.matrix = *static_cast<const CameraMatrix*>(package);
    if (&type != &representation<Image>()) return;
    ++picture;
    taken = true;
    seen.time = static_cast<const Image*>(package)->time;
  });
  std::vector<LabelError> errors;
  const auto length =
      static_cast<double>(std::max<std::size_t>(1, platform.player().moments().size()));
  while (progress(static_cast<double>(platform.player().position()) / length)) {
    taken = false;
    const auto more = platform.step();
    if (!more) return more.error();
    if (!*more) break;
    if (!taken || (!labels.balls.contains(picture) && !labels.fields.contains(picture))) continue;
    const Robot& robot = platform.robot();
    copyProvided(robot, seen.ball);
    copyProvided(robot, seen.landmarks);
    copyProvided(robot, seen.lines);
    copyProvided(robot, seen.players);
    copyProvided(robot, seen.matrix);
    FieldDimensions field;
    if (const auto* own = robot.provided<FieldDimensions>())
      field = *own;
    else if (const auto* own = robot.setup().configuration->find<FieldDimensions>())
      field = *own;
    // What vision has not looked at yet is not this image's.
    if (seen.ball.time != seen.time) seen.ball = {};
    if (seen.landmarks.time != seen.time) seen.landmarks = {};
    if (seen.lines.time != seen.time) seen.lines = {};
    if (seen.players.time != seen.time) seen.players = {};
    for (LabelError& error : errorsIn(labels, picture, seen, field.ballRadius))
      errors.push_back(std::move(error));
  }
  return errors;
}

}  // namespace gt
