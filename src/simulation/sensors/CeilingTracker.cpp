#include "simulation/sensors/CeilingTracker.h"

#include <cmath>

#include "simulation/world/Oracle.h"
#include "streams/RecordedMessage.h"
#include "streams/mcap/Mcap.h"

namespace gt {
namespace {

constexpr std::int64_t lost = 500;  // ms without observation after which a track begins anew

}  // namespace

void CeilingTracker::Track::follow(const Vector2d& place, Time time) {
  // Gains for images 40 ms apart: a kick is followed within three of them.
  constexpr double alpha = 0.5, beta = 0.25;
  const double seconds = static_cast<double>(time - seen) / 1000;
  if (time - seen > lost) {
    *this = {place, Vector2d::Zero(), time};
    return;
  }
  if (seconds <= 0) return;
  const Vector2d expected = at(time), innovation = place - expected;
  position = expected + alpha * innovation;
  speed += beta / seconds * innovation;
  seen = time;
}

Vector2d CeilingTracker::Track::at(Time time) const {
  return position + speed * (static_cast<double>(time - seen) / 1000);
}

void CeilingTracker::update(const CeilingCameraPercept& percept) {
  for (const MarkedRobot& robot : percept.robots) {
    if (robot.number < 1 || robot.number > 4 || robot.teamColor > TeamColor::blue ||
        !robot.pose.translation.allFinite() || !std::isfinite(robot.pose.rotation))
      continue;
    RobotTrack& track = robots_[robot.teamColor][static_cast<std::size_t>(robot.number - 1)];
    const double turned = normalize(robot.pose.rotation - track.rotation);
    const bool fresh = percept.time - track.place.seen > lost;
    track.rotation = normalize(track.rotation + (fresh ? 1 : 0.5) * turned);
    track.place.follow(robot.pose.translation, percept.time);
  }
  if (percept.ballSeen && percept.ball.allFinite()) ball_.follow(percept.ball, percept.time);
}

bool CeilingTracker::fill(TeamColor team, int number, Time now, OracledWorldState& state) const {
  const RobotTrack& self = robots_[team][static_cast<std::size_t>(number - 1)];
  if (now - self.place.seen > lost) return false;
  state.time = now;
  state.robotPose = toTeam(team, Pose2D{self.rotation, self.place.at(now)});
  const bool ballSeen = now - ball_.seen <= lost;
  state.ballPosition = toTeam(team, ballSeen ? ball_.at(now) : ball_.position);
  state.ballSpeed = ballSeen ? toTeam(team, ball_.speed) : Vector2d::Zero();
  state.others.clear();
  for (const TeamColor color : {TeamColor::red, TeamColor::blue})
    for (int i = 1; i <= 4; ++i) {
      const RobotTrack& other = robots_[color][static_cast<std::size_t>(i - 1)];
      if ((color == team && i == number) || now - other.place.seen > lost) continue;
      state.others.push_back({color, i, toTeam(team, Pose2D{other.rotation, other.place.at(now)})});
    }
  return true;
}

Result<std::vector<CeilingCameraPercept>> readCeilingLog(const std::string& path) {
  auto reader = McapReader::open(path);
  if (!reader) return reader.error();
  std::optional<MessageDefinition> definition;
  std::uint16_t channel = 0;
  for (const McapChannel& c : reader->channels())
    if (c.topic == ceilingTopic) {
      auto parsed = MessageDefinition::parse(c.schemaName, c.schemaText);
      if (!parsed) return Error{.file = path, .field = c.topic, .what = parsed.error().what};
      definition = *std::move(parsed);
      channel = c.id;
    }
  if (!definition)
    return Error{.file = path, .field = ceilingTopic, .what = "there is no such topic"};
  std::vector<CeilingCameraPercept> percepts;
  while (const auto message = reader->next()) {
    if (message->channel != channel) continue;
    CeilingCameraPercept percept;
    if (auto done = readRecorded(*definition, message->data, percept); !done)
      return Error{.file = path, .field = ceilingTopic, .what = done.error().what};
    percepts.push_back(std::move(percept));
  }
  // The log is the reference that others are measured against, so it must be complete.
  if (!reader->damage().empty()) return reader->damage().front();
  return percepts;
}

}  // namespace gt
