#include "modules/modeling/players/TrackingPlayersLocator.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "modules/modeling/players/Teammates.h"

namespace gt {
namespace {

const DebugKey drawTracks{"PlayersLocator/tracks"};

constexpr std::size_t mostTracks = 16;

double squared(double x) {
  return x * x;
}

}  // namespace

void TrackingPlayersLocator::update(const PlayersPercept& percept, const CameraMatrix& camera,
                                    const RobotPose& robotPose, const TeamMessages& messages,
                                    const FieldDimensions& field, const Player& player,
                                    const FrameInfo& frame, PlayersCollection& players,
                                    Debug& debug) {
  const double seconds =
      lastUpdate_ == never() ? 0 : static_cast<double>(frame.time - lastUpdate_) / 1000;
  lastUpdate_ = frame.time;
  const bool isNew = percept.time != lastPercept_;
  lastPercept_ = percept.time;
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    Tracks& tracks = tracks_[team];
    predict(tracks, frame.time, seconds);
    if (!isNew) continue;
    observe(percept.players[team], percept.time, robotPose, field, tracks);
    if (camera.valid) miss(camera, robotPose, tracks);
  }
  players.time = frame.time;
  players.ownTeam.clear();
  addMates(messages, {parameters.silence, parameters.leastValidity}, player, frame.time,
           players.ownTeam);
  players.seenOpponents.clear();
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const Track& track : tracks_[team]) {
      if (track.certainty < parameters.known) continue;
      const bool own = team == player.teamColor;
      std::vector<LocatedPlayer>& located = own ? players.ownTeam : players.seenOpponents;
      const bool known = std::ranges::any_of(located, [&](const LocatedPlayer& other) {
        return (other.position - track.position).norm() < parameters.playerSize;
      });
      if (!known && located.size() < (own ? 3 : 4))
        located.push_back({track.position, track.lastSeen, track.certainty, 0,
                           std::sqrt(track.covariance.trace() / 2)});
    }
  collect(players.seenOpponents, messages, player, frame.time);
  merge(players.opponents);
  drawPlayers(players, player.teamColor, debug);
  if (auto canvas = debug.onField(drawTracks))
    for (const TeamColor team : {TeamColor::red, TeamColor::blue})
      for (const Track& track : tracks_[team])
        canvas.circle(track.position, std::sqrt(track.covariance.trace() / 2), colorOf(team),
                      1 + 2 * track.certainty);
}

void TrackingPlayersLocator::predict(Tracks& tracks, Time now, double seconds) const {
  std::erase_if(tracks, [&](const Track& track) {
    return now - track.lastSeen >= parameters.memory || track.certainty < 0.1;
  });
  for (Track& track : tracks)
    track.covariance.diagonal().array() += squared(parameters.walk) * seconds;
}

// Assigns percepts and players that are nearest to each other, one to one. A percept that fits no
// player becomes a new player.
void TrackingPlayersLocator::observe(const std::vector<Vector2d>& seen, Time time,
                                     const RobotPose& robotPose, const FieldDimensions& field,
                                     Tracks& tracks) const {
  for (Track& track : tracks) track.matched = false;
  const std::size_t before = tracks.size();
  for (const Vector2d& offset : seen) {
    const double distance = std::max(offset.norm(), 1.);
    if (distance > parameters.farthest) continue;
    const double along = std::hypot(parameters.leastNoise, parameters.alongShare * distance);
    const double across = std::hypot(parameters.leastNoise, parameters.acrossShare * distance);
    const Vector2d away = rotated(offset / distance, robotPose.pose.rotation);
    const Eigen::Matrix2d noise = squared(across) * Eigen::Matrix2d::Identity() +
                                  (squared(along) - squared(across)) * away * away.transpose();
    // Players stand on the field: what is seen a little beyond its border is nearer.
    const Vector2d place = robotPose.pose * offset, position = nearestOnField(place, field);
    if ((place - position).norm() > parameters.outside) continue;
    Track* nearest = nullptr;
    double least = squared(parameters.gate);
    for (std::size_t i = 0; i < before; ++i) {
      if (tracks[i].matched) continue;
      const Vector2d apart = position - tracks[i].position;
      const double value = apart.dot((tracks[i].covariance + noise).inverse() * apart);
      if (value >= least) continue;
      least = value;
      nearest = &tracks[i];
    }
    if (nearest) {
      const Eigen::Matrix2d gain = nearest->covariance * (nearest->covariance + noise).inverse();
      nearest->position += gain * (position - nearest->position);
      nearest->covariance = (Eigen::Matrix2d::Identity() - gain) * nearest->covariance;
      nearest->certainty += parameters.seen * (1 - nearest->certainty);
      nearest->lastSeen = time;
      nearest->matched = true;
    } else if (tracks.size() < mostTracks) {
      tracks.push_back({position, noise, time, parameters.seen, true});
    }
  }
  // The surest first.
  std::ranges::sort(tracks, std::greater{}, &Track::certainty);
}

// Expects a player to be seen if its middle is well within the image and it is not far away.
void TrackingPlayersLocator::miss(const CameraMatrix& camera, const RobotPose& robotPose,
                                  Tracks& tracks) const {
  constexpr double height = 100, border = 20;  // mm, pixels
  const Matrix3d toCamera = camera.pose.rotation.transpose();
  for (Track& track : tracks) {
    if (track.matched) continue;
    const Vector2d place = relative(robotPose.pose, track.position);
    if (place.norm() > parameters.missedRange) continue;
    const Vector3d ray =
        toCamera * (Vector3d{place.x(), place.y(), height} - camera.pose.translation);
    if (ray.x() < 1) continue;
    const Vector2d p = camera.info.project(ray);
    if (p.x() > border && p.y() > border && p.x() < camera.info.width - border &&
        p.y() < camera.info.height - border)
      track.certainty *= parameters.missed;
  }
}

void TrackingPlayersLocator::collect(const std::vector<LocatedPlayer>& own,
                                     const TeamMessages& messages, const Player& player, Time now) {
  reports_.clear();
  for (const LocatedPlayer& seen : own)
    reports_.push_back({seen.position, squared(seen.standardDeviation), seen.lastSeen,
                        seen.validity, messages.byPlayer.size()});
  const MessageRule rule{parameters.silence, parameters.leastValidity};
  for (std::size_t robot = 0; robot < messages.byPlayer.size(); ++robot) {
    const TeamMessages::Received& received = messages.byPlayer[robot];
    if (!rule.accepts(received, player, now)) continue;
    const auto silence = now - received.timeReceived;
    for (const SeenOpponent& seen : received.message.opponents) {
      // Ages are differences within one clock each: the robots' clocks do not agree.
      const double age = static_cast<double>(silence) +
                         static_cast<double>(received.message.timeSent.ms) -
                         static_cast<double>(seen.lastSeen.ms);
      if (!(seen.validity > 0 && age >= 0 && age <= static_cast<double>(parameters.memory)))
        continue;
      const double variance = squared(seen.standardDeviation) + squared(parameters.poseNoise) +
                              squared(parameters.walk) * static_cast<double>(silence) / 1000;
      if (std::isfinite(variance) && seen.position.allFinite())
        reports_.push_back({seen.position, variance, now - static_cast<std::int64_t>(age),
                            std::min(seen.validity, 1.), robot});
    }
  }
  std::ranges::sort(reports_, std::less{}, &Report::variance);
}

// Merges reports of one opponent by several robots into their mean, weighted by the inverse
// variances. A robot reports each opponent once.
void TrackingPlayersLocator::merge(std::vector<LocatedPlayer>& players) {
  players.clear();
  for (std::size_t i = 0; i < reports_.size() && players.size() < 4; ++i) {
    const Report& first = reports_[i];
    if (first.merged) continue;
    LocatedPlayer merged{first.position, first.lastSeen, first.certainty};
    Vector2d sum = first.position / first.variance;
    double weights = 1 / first.variance;
    std::array<bool, std::tuple_size_v<decltype(TeamMessages::byPlayer)> + 1> heard{};
    heard[first.robot] = true;
    for (std::size_t k = i + 1; k < reports_.size(); ++k) {
      Report& other = reports_[k];
      if (other.merged || heard[other.robot]) continue;
      const double same = std::max(parameters.playerSize,
                                   parameters.gate * std::sqrt(first.variance + other.variance));
      if ((other.position - first.position).norm() > same) continue;
      heard[other.robot] = other.merged = true;
      sum += other.position / other.variance;
      weights += 1 / other.variance;
      merged.lastSeen = std::max(merged.lastSeen, other.lastSeen);
      merged.validity = 1 - (1 - merged.validity) * (1 - other.certainty);
    }
    merged.position = sum / weights;
    merged.standardDeviation = std::sqrt(1 / weights);
    players.push_back(merged);
  }
}

}  // namespace gt
