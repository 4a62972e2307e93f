#include "modules/modeling/players/GO2003PlayersLocator.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/players/Teammates.h"

namespace gt {
namespace {

const DebugKey drawGrid{"PlayersLocator/distribution"};

constexpr std::size_t mostSightings = 512;

/// Moves a point outside of a rectangle about the origin to its border, on the line to `from`.
Vector2d projectedToBorder(const Vector2d& from, const Vector2d& point, const Vector2d& half) {
  const Vector2d start = from.cwiseMax(-half).cwiseMin(half), way = point - start;
  double share = 1;
  for (int k = 0; k < 2; ++k)
    if (std::abs(point[k]) > half[k])
      share = std::min(share, (std::copysign(half[k], point[k]) - start[k]) / way[k]);
  return start + std::max(share, 0.) * way;
}

}  // namespace

void GO2003PlayersLocator::update(const PlayersPercept& percept, const RobotPose& robotPose,
                                  const TeamMessages& messages, const FieldDimensions& field,
                                  const Player& player, const FrameInfo& frame,
                                  PlayersCollection& players, Debug& debug) {
  setGrid(field);
  for (const TeamColor color : {TeamColor::red, TeamColor::blue}) {
    Team& team = teams_[color];
    std::erase_if(team.sightings, [&](const Sighting& sighting) {
      return frame.time - sighting.time >= parameters.memory;
    });
    if (percept.time != lastPercept_)
      remember(percept.players[color], percept.time, robotPose, field, team);
    const bool own = color == player.teamColor;
    std::vector<LocatedPlayer>& located = own ? players.ownTeam : players.opponents;
    located.clear();
    if (own)
      addMates(messages, {parameters.silence, parameters.leastValidity}, player, frame.time,
               located);
    distribute(team, frame.time);
    locate(team, frame.time, located);
    located.resize(std::min<std::size_t>(located.size(), own ? 3 : 4));
  }
  lastPercept_ = percept.time;
  players.time = frame.time;
  players.seenOpponents.clear();
  drawPlayers(players, player.teamColor, debug);
  if (auto canvas = debug.onField(drawGrid))
    for (const TeamColor color : {TeamColor::red, TeamColor::blue})
      for (const Sighting& sighting : teams_[color].sightings)
        canvas.point(sighting.position, colorOf(color), 2);
}

void GO2003PlayersLocator::setGrid(const FieldDimensions& field) {
  halfLength_ = field.xGroundline;
  halfWidth_ = field.ySideline;
  // However large the field, the grid stays within bounds.
  const double cell = std::max(parameters.cell, std::max(halfLength_, halfWidth_) / 100);
  columns_ = static_cast<int>(std::ceil(2 * halfLength_ / cell));
  rows_ = static_cast<int>(std::ceil(2 * halfWidth_ / cell));
  const int reach = static_cast<int>(std::ceil(2.5 * parameters.spread / cell));
  kernel_.resize(static_cast<std::size_t>(2 * reach + 1));
  for (int i = -reach; i <= reach; ++i)
    kernel_[static_cast<std::size_t>(i + reach)] =
        std::exp(-0.5 * std::pow(i * cell / parameters.spread, 2));
}

void GO2003PlayersLocator::remember(const std::vector<Vector2d>& seen, Time time,
                                    const RobotPose& robotPose, const FieldDimensions& field,
                                    Team& team) const {
  const Vector2d half{field.xGroundline, field.ySideline};
  for (const Vector2d& offset : seen) {
    const Vector2d place = robotPose.pose * offset;
    if ((place - nearestOnField(place, field)).norm() > parameters.outside) continue;
    if (team.sightings.size() < mostSightings)
      team.sightings.push_back({projectedToBorder(robotPose.pose.translation, place, half), time});
  }
}

double GO2003PlayersLocator::weight(const Sighting& sighting, Time now) const {
  return 1 - static_cast<double>(now - sighting.time) / static_cast<double>(parameters.memory);
}

// Counts the percepts in each cell and smooths the counts in the direction of x, then of y.
void GO2003PlayersLocator::distribute(Team& team, Time now) {
  const auto cells = static_cast<std::size_t>(columns_ * rows_);
  team.density.assign(cells, 0);
  smoothed_.assign(cells, 0);
  const double cellX = 2 * halfLength_ / columns_, cellY = 2 * halfWidth_ / rows_;
  for (const Sighting& sighting : team.sightings) {
    const Vector2d p = sighting.position - cornerOfGrid();
    const int x = std::clamp(static_cast<int>(p.x() / cellX), 0, columns_ - 1);
    const int y = std::clamp(static_cast<int>(p.y() / cellY), 0, rows_ - 1);
    team.density[static_cast<std::size_t>(y * columns_ + x)] += weight(sighting, now);
  }
  const auto spread = [&](const std::vector<double>& from, std::vector<double>& to, int stride,
                          int length) {
    const int reach = static_cast<int>(kernel_.size() / 2);
    for (int i = 0; i < columns_ * rows_; ++i) {
      const double value = from[static_cast<std::size_t>(i)];
      if (value == 0) continue;
      const int at = i / stride % length;
      for (int k = std::max(-reach, -at); k <= std::min(reach, length - 1 - at); ++k)
        to[static_cast<std::size_t>(i + k * stride)] +=
            value * kernel_[static_cast<std::size_t>(k + reach)];
    }
  };
  spread(team.density, smoothed_, 1, columns_);
  std::fill(team.density.begin(), team.density.end(), 0.);
  spread(smoothed_, team.density, columns_, rows_);
}

// Appends a player for each maximum of the distribution, the highest first, at the mean of the
// percepts around it. Maxima near a player that is already in the list are skipped.
void GO2003PlayersLocator::locate(Team& team, Time now, std::vector<LocatedPlayer>& players) {
  const auto density = [&](int i) { return team.density[static_cast<std::size_t>(i)]; };
  maxima_.clear();
  for (int i = 0; i < columns_ * rows_; ++i) {
    if (density(i) < parameters.threshold) continue;
    const int x = i % columns_, y = i / columns_;
    bool highest = true;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (x + dx >= 0 && x + dx < columns_ && y + dy >= 0 && y + dy < rows_)
          highest = highest && density(i) >= density(i + dy * columns_ + dx);
    if (highest) maxima_.push_back(i);
  }
  std::sort(maxima_.begin(), maxima_.end(), [&](int a, int b) {
    return density(a) != density(b) ? density(a) > density(b) : a < b;
  });
  for (const int i : maxima_) {
    const Vector2d top =
        cornerOfGrid() + Vector2d{(i % columns_ + 0.5) * 2 * halfLength_ / columns_,
                                  (i / columns_ + 0.5) * 2 * halfWidth_ / rows_};
    LocatedPlayer player;
    Vector2d sum = Vector2d::Zero();
    double weights = 0;
    for (const Sighting& sighting : team.sightings) {
      const double away = (sighting.position - top).norm();
      if (away > 2 * parameters.spread) continue;
      const double w = weight(sighting, now);
      sum += w * sighting.position;
      weights += w;
      player.lastSeen = std::max(player.lastSeen, sighting.time);
    }
    if (weights <= 0) continue;
    player.position = sum / weights;
    player.validity = density(i) / (1 + density(i));
    const bool known = std::any_of(players.begin(), players.end(), [&](const LocatedPlayer& p) {
      return (p.position - player.position).norm() < parameters.playerSize;
    });
    if (!known) players.push_back(player);
  }
}

}  // namespace gt
