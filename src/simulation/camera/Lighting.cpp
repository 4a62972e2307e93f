#include "simulation/camera/Lighting.h"

#include <algorithm>
#include <cmath>

#include "simulation/camera/GeomColor.h"

namespace gt {
namespace {

constexpr double farAway = 1000;       // m
constexpr double offSurface = 0.0005;  // m: a shadow's ray does not meet the surface it leaves

Vector3d vectorOf(const mjtNum* numbers) {
  return Eigen::Map<const Vector3d>(numbers);
}

Eigen::Matrix3d matrixOf(const mjtNum* numbers) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers);
}

bool isSeen(const mjModel& model, int geom) {
  return model.geom_group[geom] != hiddenGroup && rgbaOf(model, geom)[3] >= 0.5f;
}

/// The outward normal of a geom at a point of its surface, both in its own system.
Vector3d normalAt(int type, const mjtNum* size, const Vector3d& p) {
  switch (type) {
    case mjGEOM_PLANE:
      return Vector3d::UnitZ();
    case mjGEOM_CAPSULE:
      return (p - Vector3d{0, 0, std::clamp(p.z(), -size[1], size[1])}).normalized();
    case mjGEOM_ELLIPSOID:
      return p.cwiseQuotient(vectorOf(size).cwiseAbs2()).normalized();
    case mjGEOM_CYLINDER:
      if (size[1] - std::abs(p.z()) < size[0] - p.head<2>().norm())
        return {0, 0, std::copysign(1., p.z())};
      return Vector3d{p.x(), p.y(), 0}.normalized();
    case mjGEOM_BOX: {
      int side = 0;
      p.cwiseAbs().cwiseQuotient(vectorOf(size)).maxCoeff(&side);
      return std::copysign(1., p[side]) * Vector3d::Unit(side);
    }
    default:
      return p.normalized();
  }
}

/// Whether a ray passes nearer to a geom than its bounding sphere is wide.
bool mayMeet(const mjModel& model, const mjData& data, int geom, const Vector3d& from,
             const Vector3d& direction, double most) {
  const double bound = model.geom_rbound[geom];
  if (bound <= 0) return true;  // a plane
  const Vector3d d = vectorOf(data.geom_xpos + 3 * geom) - from;
  const double ahead = d.dot(direction);
  return ahead > -bound && ahead < most + bound && d.squaredNorm() - ahead * ahead < bound * bound;
}

double distanceTo(const mjModel& model, const mjData& data, int geom, const Vector3d& from,
                  const Vector3d& direction) {
  if (model.geom_type[geom] == mjGEOM_MESH)
    return mj_rayMesh(&model, &data, geom, from.data(), direction.data());
  return mju_rayGeom(data.geom_xpos + 3 * geom, data.geom_xmat + 9 * geom,
                     model.geom_size + 3 * geom, from.data(), direction.data(),
                     model.geom_type[geom]);
}

}  // namespace

RayHit Lighting::castAt(const mjData& data, int geom, const Vector3d& from,
                        const Vector3d& direction) const {
  RayHit hit;
  const double distance = distanceTo(*model_, data, geom, from, direction);
  if (distance < 0) return hit;
  hit.geom = geom;
  hit.distance = distance;
  hit.point = from + distance * direction;
  const Eigen::Matrix3d rotation = matrixOf(data.geom_xmat + 9 * geom);
  const Vector3d local = rotation.transpose() * (hit.point - vectorOf(data.geom_xpos + 3 * geom));
  hit.normal = rotation * normalAt(model_->geom_type[geom], model_->geom_size + 3 * geom, local);
  if (hit.normal.dot(direction) > 0) hit.normal = -hit.normal;
  return hit;
}

RayHit Lighting::cast(const mjData& data, const Vector3d& from, const Vector3d& direction,
                      int hiddenBody) const {
  int nearest = -1;
  double distance = farAway;
  for (int geom = 0; geom < model_->ngeom; ++geom) {
    if (!isSeen(*model_, geom) || model_->geom_bodyid[geom] == hiddenBody ||
        !mayMeet(*model_, data, geom, from, direction, distance))
      continue;
    const double d = distanceTo(*model_, data, geom, from, direction);
    if (d < 0 || d >= distance) continue;
    nearest = geom;
    distance = d;
  }
  return nearest < 0 ? RayHit{} : castAt(data, nearest, from, direction);
}

bool Lighting::hidden(const mjData& data, const Vector3d& from, const Vector3d& direction,
                      double distance, int lit) const {
  for (int geom = 0; geom < model_->ngeom; ++geom) {
    if (geom == lit || model_->geom_group[geom] < 2 || !isSeen(*model_, geom) ||
        !mayMeet(*model_, data, geom, from, direction, distance))
      continue;
    const double d = distanceTo(*model_, data, geom, from, direction);
    if (d >= 0 && d < distance) return true;
  }
  return false;
}

Eigen::Vector3f Lighting::lightFrom(const mjData& data, int light, const RayHit& hit,
                                    bool shadows) const {
  const mjModel& m = *model_;
  Eigen::Vector3f intensity = Eigen::Map<const Eigen::Vector3f>(m.light_ambient + 3 * light);
  const int body = m.light_bodyid[light];
  const Eigen::Matrix3d rotation = matrixOf(data.xmat + 9 * body);
  const Vector3d beam = (rotation * vectorOf(m.light_dir + 3 * light)).normalized();
  const bool directional = m.light_directional[light] != 0;
  const Vector3d source =
      vectorOf(data.xpos + 3 * body) + rotation * vectorOf(m.light_pos + 3 * light);
  const Vector3d toLight = directional ? Vector3d{-beam} : Vector3d{source - hit.point};
  const double distance = directional ? farAway : toLight.norm();
  const Vector3d direction = toLight.normalized();
  const double facing = hit.normal.dot(direction);
  if (facing <= 0) return intensity;
  double strength = facing;
  if (!directional) {
    const float* fading = m.light_attenuation + 3 * light;
    strength /= std::max(1e-6, fading[0] + distance * (fading[1] + distance * fading[2]));
    const double inBeam = -direction.dot(beam);
    if (m.light_cutoff[light] < 90) {
      if (inBeam < std::cos(fromDegrees(m.light_cutoff[light]))) return intensity;
      strength *= std::pow(inBeam, m.light_exponent[light]);
    }
  }
  if (shadows && m.light_castshadow[light] &&
      hidden(data, hit.point + offSurface * hit.normal, direction, distance, hit.geom))
    return intensity;
  return intensity + static_cast<float>(strength) *
                         Eigen::Map<const Eigen::Vector3f>(m.light_diffuse + 3 * light);
}

PackedColor Lighting::color(const mjData& data, const RayHit& hit, ColorClass colorClass,
                            bool shadows) const {
  Eigen::Vector3f intensity = Eigen::Map<const Eigen::Vector3f>(model_->vis.headlight.ambient);
  for (int light = 0; light < model_->nlight; ++light)
    if (model_->light_active[light]) intensity += lightFrom(data, light, hit, shadows);
  const float* rgba = rgbaOf(*model_, hit.geom);
  const Eigen::Vector3f rgb{rgba[0], rgba[1], rgba[2]};
  return packColor(rgb.cwiseProduct(intensity).cwiseMin(1.0f), colorClass);
}

void Lighting::shade(const mjData& data, const CameraView& view, bool rollingShutter, bool shadows,
                     const CameraScene& scene, Rasterizer& picture) const {
  for (int y = 0; y < picture.height(); ++y) {
    const double share = rollingShutter ? static_cast<double>(y) / (picture.height() - 1) : 0.5;
    const Pose3D pose = interpolated(view.first, view.last, share);
    const Vector3d from = pose.translation / 1000;
    const std::int32_t* geoms = picture.geomRow(y);
    PackedColor* colors = picture.row(y);
    for (int x = 0; x < picture.width(); ++x) {
      if (geoms[x] < 0) continue;
      const Vector3d ray = (pose.rotation * view.info.ray(x + 0.5, y + 0.5)).normalized();
      const RayHit hit = castAt(data, geoms[x], from, ray);
      // At an edge the ray may miss the geom that the pixel shows: the pixel keeps its flat color.
      if (hit.geom >= 0) colors[x] = color(data, hit, scene.classOf(hit.geom), shadows);
    }
  }
}

void Facette::take(const Lighting& lighting, const CameraScene& scene, const mjData& data,
                   const Pose3D& pose, int hiddenBody, bool shadows, Image& image) const {
  image.info.width = columns;
  image.info.height = rows;
  image.allocate();
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const double pan = width * (0.5 - (x + 0.5) / columns),
                   tilt = height * (0.5 - (y + 0.5) / rows);
      const Vector3d ray = pose.rotation * (rotationZ(pan) * rotationY(-tilt) * Vector3d::UnitX());
      const RayHit hit = lighting.cast(data, pose.translation / 1000, ray, hiddenBody);
      const PackedColor color = hit.geom < 0
                                    ? scene.background()
                                    : lighting.color(data, hit, scene.classOf(hit.geom), shadows);
      image.at(x, y) = {static_cast<std::uint8_t>(color), static_cast<std::uint8_t>(color >> 8),
                        static_cast<std::uint8_t>(color >> 16)};
    }
}

}  // namespace gt
