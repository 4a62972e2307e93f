#include "modules/modeling/selflocator/PoseTemplates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gt {
namespace {

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double determinant(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  return a.dot(b.cross(c));
}

/// Sightings of up to six flags, or three memorized ones, and four goal posts.
struct Sightings {
  std::array<Sighting, 10> list;
  std::size_t count = 0;
  void add(const Sighting& s) { list[count++] = s; }
};

void addPosts(Sightings& sightings, const LandmarksPercept& percept, TeamColor team,
              const FieldDimensions& field) {
  for (int i = 0; i < percept.numberOfGoals; ++i) {
    const GoalPercept& goal = percept.goals[static_cast<std::size_t>(i)];
    const ConditionalBoundary& edges = goal.boundary;
    if (!edges.leftOnBorder)
      sightings.add({positionOfPost(goal.color, true, team, field), direction(edges.left)});
    if (!edges.rightOnBorder)
      sightings.add({positionOfPost(goal.color, false, team, field), direction(edges.right)});
  }
}

}  // namespace

std::optional<Pose2D> triangulate(const Sighting& a, const Sighting& b, const Sighting& c) {
  // With rotation t and q = R(-t) * position, each sighting m of L demands
  //   cos t * (m x L) - sin t * (m . L) + m_y * q_x - m_x * q_y = 0.
  // Three such equations leave one direction in the space of (cos t, sin t, q_x, q_y): the cross
  // product of their rows.
  const std::array<const Sighting*, 3> sightings{&a, &b, &c};
  Matrix3d m;  // Columns as vectors over the three sightings: cos, sin, q_x; q_y apart.
  Vector3d my;
  for (int i = 0; i < 3; ++i) {
    const Sighting& s = *sightings[static_cast<std::size_t>(i)];
    const Vector2d u = s.direction.normalized();
    m.row(i) << cross(u, s.landmark) / 1000, -u.dot(s.landmark) / 1000, u.y();
    my(i) = -u.x();
  }
  const Vector3d c0 = m.col(0), c1 = m.col(1), c2 = m.col(2);
  const double cosine = determinant(c1, c2, my), sine = -determinant(c0, c2, my);
  const double length = std::hypot(cosine, sine);
  if (length < 1e-4) return std::nullopt;
  const Vector2d q = Vector2d{determinant(c0, c1, my), -determinant(c0, c1, c2)} * (1000 / length);
  Pose2D pose;
  pose.rotation = std::atan2(sine, cosine);
  pose.translation = rotated(q, pose.rotation);
  // The opposite direction solves the equations as well.
  int ahead = 0;
  for (const Sighting* s : sightings)
    ahead += relative(pose, s->landmark).dot(s->direction) > 0 ? 1 : -1;
  if (ahead == -3) pose.rotation = normalize(pose.rotation + pi);
  if (std::abs(ahead) != 3) return std::nullopt;
  return pose;
}

int posesFrom(const Sighting& located, const Sighting& second, std::array<Pose2D, 2>& poses) {
  const double distance = located.direction.norm();
  const Vector2d unit = second.direction.normalized();
  const Vector2d base = second.landmark - located.landmark;
  // The law of cosines in the triangle of both landmarks and the observer, for the other distance.
  const double along = located.direction.dot(unit);
  const double squared = base.squaredNorm() - distance * distance + along * along;
  if (squared < 0) return 0;
  int count = 0;
  for (const double sign : {1.0, -1.0}) {
    const double other = along + sign * std::sqrt(squared);
    if (other <= 0) continue;
    const Vector2d seen = unit * other - located.direction;
    Pose2D pose;
    pose.rotation = normalize(angleOf(base) - angleOf(seen));
    pose.translation = located.landmark - rotated(located.direction, pose.rotation);
    poses[static_cast<std::size_t>(count++)] = pose;
  }
  return count;
}

void PoseTemplates::move(const Pose2D& odometry) {
  for (MemorizedFlag& flag : flags_) flag.position = relative(odometry, flag.position);
}

void PoseTemplates::update(const LandmarksPercept& percept, TeamColor team,
                           const FieldDimensions& field) {
  field_ = field;
  cameraOffset_ = percept.cameraOffset.head<2>();
  count_ = 0;
  for (int i = 0; i < percept.numberOfFlags; ++i)
    if (percept.flags[static_cast<std::size_t>(i)].distance > 0)
      memorize(percept.flags[static_cast<std::size_t>(i)]);
  locateByFlags(percept, team);
  triangulateAll(percept, team);
}

std::optional<Pose2D> PoseTemplates::take(Random& random) {
  if (count_ == 0) return std::nullopt;
  std::swap(poses_[random.index(static_cast<std::uint64_t>(count_))],
            poses_[static_cast<std::size_t>(count_ - 1)]);
  return poses_[static_cast<std::size_t>(--count_)];
}

void PoseTemplates::memorize(const FlagPercept& flag) {
  const auto end = flags_.begin() + numberOfFlags_;
  auto place = std::find_if(flags_.begin(), end,
                            [&](const MemorizedFlag& f) { return f.type == flag.type; });
  if (place == end) {
    if (numberOfFlags_ < 3)
      ++numberOfFlags_;
    else
      --place;
  }
  std::rotate(flags_.begin(), place, place + 1);
  flags_[0] = {flag.type, direction(flag.angle) * flag.distance};
}

void PoseTemplates::triangulateAll(const LandmarksPercept& percept, TeamColor team) {
  Sightings seen;
  for (int i = 0; i < numberOfFlags_; ++i) {
    const MemorizedFlag& flag = flags_[static_cast<std::size_t>(i)];
    seen.add({positionOf(flag.type, team, field_), flag.position - cameraOffset_});
  }
  addPosts(seen, percept, team, field_);
  for (std::size_t i = 0; i < seen.count; ++i)
    for (std::size_t j = i + 1; j < seen.count; ++j)
      for (std::size_t k = j + 1; k < seen.count; ++k)
        if (const auto pose = triangulate(seen.list[i], seen.list[j], seen.list[k])) add(*pose);
}

void PoseTemplates::locateByFlags(const LandmarksPercept& percept, TeamColor team) {
  Sightings seen;
  for (int i = 0; i < percept.numberOfFlags; ++i) {
    const FlagPercept& flag = percept.flags[static_cast<std::size_t>(i)];
    const double distance = flag.distance > 0 ? flag.distance : 1e4;
    seen.add(
        {positionOf(flag.type, team, field_), direction(flag.angle) * distance - cameraOffset_});
  }
  addPosts(seen, percept, team, field_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(percept.numberOfFlags); ++i)
    for (std::size_t j = 0; j < seen.count; ++j) {
      if (i == j || percept.flags[i].distance <= 0) continue;
      std::array<Pose2D, 2> poses;
      const int found = posesFrom(seen.list[i], seen.list[j], poses);
      for (int k = 0; k < found; ++k) add(poses[static_cast<std::size_t>(k)]);
    }
}

void PoseTemplates::add(const Pose2D& camera) {
  const Pose2D robot = camera * Pose2D{0, -cameraOffset_};
  if (count_ < static_cast<int>(poses_.size()) &&
      std::abs(robot.translation.x()) <= field_.xGoalBack &&
      std::abs(robot.translation.y()) <= field_.ySideline)
    poses_[static_cast<std::size_t>(count_++)] = robot;
}

void replaceByTemplates(const TemplateReplacement& parameters, PoseTemplates& templates,
                        const RobotPose* candidate, const FieldDimensions& field,
                        ParticleSet& particles, Random& random) {
  EnumArray<Likelihood, float> with = particles.meanLikelihoods();
  with[Likelihood::landmarks] = static_cast<float>(parameters.newProbability);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double likelihood = particles.likelihood[Likelihood::landmarks][i];
    if (!random.chance(parameters.replacement * (1 - likelihood))) continue;
    if (candidate && random.chance(candidate->validity))
      particles.replace(i, candidate->pose, with);
    else if (const auto pose = templates.take(random))
      particles.replace(i, *pose, with);
    else if (random.chance(parameters.randomReplacement))
      particles.replace(i, randomPose(field, random), with);
  }
}

}  // namespace gt
