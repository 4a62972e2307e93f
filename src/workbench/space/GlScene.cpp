#include "workbench/space/GlScene.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace gt {
namespace {

constexpr int mostGeoms = 20000;
constexpr double meters = 1e-3;  // per mm
constexpr float ghostAlpha = 0.35F;

std::span<mjvGeom> all(mjvScene& scene) {
  return {scene.geoms, static_cast<std::size_t>(scene.ngeom)};
}

/// Moves a geom on the field as a body that moves from one pose to another.
void moveGeom(mjvGeom& geom, const Pose2D& from, const Pose2D& to) {
  const Matrix3d turn = rotationZ(to.rotation - from.rotation);
  const Vector3d origin{from.translation.x(), from.translation.y(), 0};
  const Vector3d target{to.translation.x(), to.translation.y(), 0};
  Eigen::Map<Eigen::Vector3f> at{geom.pos};
  Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>> rotation{geom.mat};
  at = (meters * (turn * (at.cast<double>() / meters - origin) + target)).cast<float>();
  rotation = (turn * rotation.cast<double>()).cast<float>();
}

}  // namespace

GlScene::GlScene(std::shared_ptr<const mjModel> model) : model_{std::move(model)} {
  mjv_defaultScene(&scene_);
  mjv_makeScene(model_.get(), &scene_, mostGeoms);
}

GlScene::~GlScene() {
  mjv_freeScene(&scene_);
}

void GlScene::show(const World& world, const GlStyle& style) {
  mjvOption option;
  mjv_defaultOption(&option);
  for (std::size_t i = 0; i < style.groups.size(); ++i) option.geomgroup[i] = style.groups[i];
  option.flags[mjVIS_TRANSPARENT] = style.transparent;
  option.flags[mjVIS_CONTACTPOINT] = option.flags[mjVIS_CONTACTFORCE] = style.contacts;
  std::ranges::fill(option.sitegroup, mjtByte{0});
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  // It only reads the data, although its interface does not promise that.
  mjv_updateScene(&world.model(), const_cast<mjData*>(&world.data()), &option, nullptr, &camera,
                  mjCAT_ALL, &scene_);
  scene_.flags[mjRND_WIREFRAME] = style.wireFrames;
  scene_.flags[mjRND_SHADOW] = scene_.flags[mjRND_REFLECTION] = 0;
}

void GlScene::clear() {
  scene_.ngeom = 0;
  scene_.nlight = 1;
  mjvLight& light = scene_.lights[0];
  light = {};
  light.headlight = 1;
  light.directional = 1;
  for (int i = 0; i < 3; ++i) {
    light.ambient[i] = 0.5F;
    light.diffuse[i] = 0.5F;
  }
}

void GlScene::keep(const std::function<bool(int geom)>& wanted) {
  const auto geoms = all(scene_);
  const auto end = std::remove_if(geoms.begin(), geoms.end(), [&](const mjvGeom& geom) {
    return geom.objtype != mjOBJ_GEOM || !wanted(geom.objid);
  });
  scene_.ngeom = static_cast<int>(end - geoms.begin());
}

void GlScene::move(const Pose2D& from, const Pose2D& to) {
  for (mjvGeom& geom : all(scene_)) moveGeom(geom, from, to);
}

void GlScene::addGhost(int first, int last, const Pose2D& from, const Pose2D& to) {
  const int end = scene_.ngeom;
  for (int i = 0; i < end && scene_.ngeom < scene_.maxgeom; ++i) {
    const mjvGeom& geom = scene_.geoms[i];
    if (geom.objtype != mjOBJ_GEOM || geom.objid < first || geom.objid >= last) continue;
    mjvGeom& ghost = scene_.geoms[scene_.ngeom++] = geom;
    ghost.objtype = mjOBJ_UNKNOWN;  // cannot be picked
    ghost.objid = ghost.segid = -1;
    ghost.category = mjCAT_DECOR;
    ghost.transparent = 1;
    ghost.rgba[3] = ghostAlpha;
    moveGeom(ghost, from, to);
  }
}

void GlScene::add(mjtGeom shape, const Vector3d& size, const Vector3d& at, const Color& color,
                  const Matrix3d& rotation) {
  if (scene_.ngeom >= scene_.maxgeom) return;
  const Vector3d sizeInMeters = meters * size, atInMeters = meters * at;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = rotation;
  const float rgba[] = {static_cast<float>(color.r) / 255, static_cast<float>(color.g) / 255,
                        static_cast<float>(color.b) / 255, static_cast<float>(color.a) / 255};
  mjvGeom& geom = scene_.geoms[scene_.ngeom++];
  mjv_initGeom(&geom, shape, sizeInMeters.data(), atInMeters.data(), rows.data(), rgba);
  geom.category = mjCAT_DECOR;
  geom.objtype = mjOBJ_UNKNOWN;
  geom.objid = geom.segid = -1;
  geom.transparent = color.a < 255;
}

void GlScene::addLine(const Vector3d& from, const Vector3d& to, double width, const Color& color) {
  if (scene_.ngeom >= scene_.maxgeom) return;
  add(mjGEOM_CAPSULE, {1, 1, 1}, from, color);
  const Vector3d a = meters * from, b = meters * to;
  mjv_makeConnector(&scene_.geoms[scene_.ngeom - 1], mjGEOM_CAPSULE, meters * width / 2, a.x(),
                    a.y(), a.z(), b.x(), b.y(), b.z());
}

std::optional<Picked> GlScene::pick(const Ray& ray) const {
  const Vector3d from = meters * ray.from;
  std::optional<Picked> nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scene_.ngeom; ++i) {
    const mjvGeom& geom = scene_.geoms[i];
    if (geom.objtype != mjOBJ_GEOM || geom.type > mjGEOM_BOX) continue;
    const Vector3d at = Eigen::Map<const Eigen::Vector3f>{geom.pos}.cast<double>();
    mjtNum rotation[9];
    std::ranges::copy(geom.mat, rotation);
    const double met =
        mju_rayGeom(at.data(), rotation, model_->geom_size + 3 * geom.objid, from.data(),
                    ray.direction.data(), model_->geom_type[geom.objid]);
    if (met < 0 || met >= distance) continue;
    distance = met;
    nearest = Picked{geom.objid, ray.from + met / meters * ray.direction};
  }
  return nearest;
}

std::shared_ptr<const mjModel> modelToDraw(const mjModel& model) {
  Model copy = copyModel(model);
  // A view draws into its widget's own buffer.
  copy->vis.global.offwidth = copy->vis.global.offheight = 16;
  copy->vis.quality.offsamples = 0;
  copy->vis.quality.shadowsize = 0;
  // Rough enough that a machine without a graphics card draws eight robots in time.
  copy->vis.quality.numslices = 14;
  copy->vis.quality.numstacks = 7;
  return std::shared_ptr<mjModel>{copy.release(), MuJoCoDeleter{}};
}

}  // namespace gt
