#include "modules/modeling/selflocator/EdgeModel.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/FastMath.h"

namespace gt {
namespace {

/// Terms of the comparison with one point that are the same for all particles.
struct PointTerms {
  float pointX, pointY;    ///< Relative to the robot.
  float cameraX, cameraY;  ///< Relative to the robot.
  float height, distance;  ///< Of the camera above the ground, and along it to the point.
  float verticalWeight, horizontalWeight, gain, limit;

  PointTerms(const EdgeModel::Parameters& p, const Vector2d& point, const Vector3d& camera,
             double speed) {
    const double far = (point - camera.head<2>()).norm();
    const double slowness = 1 - p.verticalWeightLoss / std::max(p.verticalWeight, 1e-9) *
                                    std::clamp(speed / p.fastest, 0., 1.);
    const double ratio = far / p.correctionRange;
    pointX = static_cast<float>(point.x());
    pointY = static_cast<float>(point.y());
    cameraX = static_cast<float>(camera.x());
    cameraY = static_cast<float>(camera.y());
    height = static_cast<float>(camera.z());
    distance = static_cast<float>(far);
    verticalWeight = static_cast<float>(p.verticalWeight * std::max(slowness, 0.));
    horizontalWeight = static_cast<float>(p.horizontalWeight);
    gain = static_cast<float>(p.correction * std::max(slowness, 0.1) / (1 + ratio * ratio));
    limit = static_cast<float>(p.correctionLimit * p.correctionLimit);
  }

  /// The similarity (3.18) of the vectors, on the field, from the camera to the point and to the
  /// closest model point.
  float similarity(float seenX, float seenY, float modelX, float modelY) const {
    const float horizontal =
        fastAtan2(seenX * modelY - seenY * modelX, seenX * modelX + seenY * modelY);
    const float modelDistance = std::sqrt(modelX * modelX + modelY * modelY);
    const float vertical =
        fastAtan2(height * (modelDistance - distance), modelDistance * distance + height * height);
    return fastExp(-verticalWeight * vertical * vertical -
                   horizontalWeight * horizontal * horizontal);
  }
};

}  // namespace

void EdgeModel::prepare(const FieldDimensions& field, TeamColor team) {
  if (tables_ && team == team_ && field == field_) return;
  tables_ = std::make_unique<EdgeTables>(field, team);
  field_ = field;
  team_ = team;
}

void EdgeModel::choose(const LinesPercept& percept, int wanted, double farthest, Random& random) {
  chosen_.clear();
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
    const auto type = static_cast<EdgeType>(t);
    const std::vector<Vector2d>& points = percept.points[type];
    const auto count = std::min(static_cast<std::size_t>(wanted), points.size());
    // Evenly over the image from a random start on: neighbors give the same information.
    const double stride = static_cast<double>(points.size()) / static_cast<double>(count);
    const double start = random.uniform() * static_cast<double>(points.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(start + stride * static_cast<double>(i));
      const Vector2d& point = points[at % points.size()];
      if (point.norm() < farthest) chosen_.push_back({type, point});
    }
  }
}

void EdgeModel::observe(const Parameters& parameters, const Vector3d& camera, double speed,
                        ParticleSet& particles) {
  for (const ChosenPoint& chosen : chosen_) observe(parameters, chosen, camera, speed, particles);
}

void EdgeModel::observe(const Parameters& parameters, const ChosenPoint& chosen,
                        const Vector3d& camera, double speed, ParticleSet& particles) {
  const PointTerms terms{parameters, chosen.point, camera, speed};
  const std::size_t n = particles.size();
  modelX_.resize(n);
  modelY_.resize(n);
  float* __restrict const x = particles.x.data();
  float* __restrict const y = particles.y.data();
  const float* __restrict const c = particles.cosine.data();
  const float* __restrict const s = particles.sine.data();
  float* __restrict const modelX = modelX_.data();
  float* __restrict const modelY = modelY_.data();
  for (std::size_t i = 0; i < n; ++i) {
    const EdgeTables::Point model =
        tables_->closest(chosen.type, x[i] + c[i] * terms.pointX - s[i] * terms.pointY,
                         y[i] + s[i] * terms.pointX + c[i] * terms.pointY);
    modelX[i] = model.x;
    modelY[i] = model.y;
  }
  const ProbabilityFilter filter{static_cast<float>(parameters.rise),
                                 static_cast<float>(parameters.fall)};
  float* __restrict const likelihood = particles.likelihood[likelihoodOf(chosen.type)].data();
  for (std::size_t i = 0; i < n; ++i) {
    const float cameraX = x[i] + c[i] * terms.cameraX - s[i] * terms.cameraY;
    const float cameraY = y[i] + s[i] * terms.cameraX + c[i] * terms.cameraY;
    const float placeX = x[i] + c[i] * terms.pointX - s[i] * terms.pointY;
    const float placeY = y[i] + s[i] * terms.pointX + c[i] * terms.pointY;
    likelihood[i] =
        filter(likelihood[i], terms.similarity(placeX - cameraX, placeY - cameraY,
                                               modelX[i] - cameraX, modelY[i] - cameraY));
    // From the point to the closest one on the edge: perpendicular to it (3.3.3.3).
    const float dx = modelX[i] - placeX, dy = modelY[i] - placeY;
    const float gain = dx * dx + dy * dy < terms.limit ? terms.gain : 0;
    x[i] += gain * dx;
    y[i] += gain * dy;
  }
}

void EdgeModel::replaceImprobable(const Parameters& parameters, ParticleSet& particles,
                                  Random& random) const {
  if (chosen_.empty()) return;
  double sum = 0;
  for (const float p : particles.probability) sum += p;
  const double average = sum / static_cast<double>(particles.size());
  EnumArray<Likelihood, float> with = particles.meanLikelihoods();
  for (float& likelihood : with) likelihood *= static_cast<float>(parameters.newLikelihood);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (random.uniform() * average <= particles.probability[i]) continue;
    const ChosenPoint& chosen = chosen_[random.index(chosen_.size())];
    if (tables_->posesCount(chosen.type, chosen.point) > 0)
      particles.replace(i, tables_->drawPose(chosen.type, chosen.point, random), with);
  }
}

double SpeedBetweenImages::operator()(const OdometryData& odometry, Time now) {
  const double distance = odometry.pose.relativeTo(last_.pose).translation.norm();
  const double seconds = time_ == never() ? 0 : static_cast<double>(now - time_) / 1000;
  last_ = odometry;
  time_ = now;
  return seconds > 0 ? distance / seconds : 0;
}

}  // namespace gt
