#include "VisionTruth.h"

#include <string_view>

#include "modules/perception/scanning/CameraImage.h"

namespace gt {

VisionTruth::VisionTruth(const World& world, const SceneDescription& scene) : world_(world) {
  for (const SceneRobot* robot : scene.allRobots()) players_.push_back(robot->player());
  objects_.push_back({Kind::background, 0});
  const CameraScene camera{world.model()};
  for (int geom = 0; geom < world.model().ngeom; ++geom)
    objects_.push_back(objectOf(geom, camera.classOf(geom)));
}

VisionTruth::Object VisionTruth::objectOf(int geom, ColorClass color) const {
  const mjModel& model = world_.model();
  for (std::size_t i = 0; i < world_.robotCount(); ++i) {
    const RobotParts& parts = world_.parts(i);
    if (geom < parts.firstGeom || geom >= parts.lastGeom) continue;
    const bool tricot = color == ColorClass::red || color == ColorClass::blue;
    return {tricot ? Kind::tricot : Kind::robot, i};
  }
  if (model.geom_bodyid[geom] == world_.ballBody(0)) return {Kind::ball, 0};
  const std::string_view name = model.names + model.name_geomadr[geom];
  for (std::size_t type = 0; type < enumCount<FlagType>; ++type)
    if (name.starts_with(enumNames<FlagType>[type]) && !name.ends_with("Base"))
      return {Kind::flag, type};
  const bool outside = name.ends_with("Outside");
  if (name.starts_with("goalYellow") && !outside) return {Kind::goal, 0};
  if (name.starts_with("goalSkyblue") && !outside) return {Kind::goal, 1};
  if (name.starts_with("audience")) return {Kind::background, 0};
  if (name.starts_with("carpet") || name == "circleGreen" || name == "floor")
    return {Kind::ground, 0};
  if (name.starts_with("line") || name == "circleWhite") return {Kind::line, 0};
  if (name.starts_with("wall") || name.starts_with("corner")) return {Kind::border, 0};
  return {};
}

void VisionTruth::look(const GameView& view) {
  view_ = &view;
  counts_.assign(objects_.size(), 0);
  for (const int geom : view.truth.geoms) ++counts_[static_cast<std::size_t>(geom + 1)];
}

Vector2d VisionTruth::post(GoalColor color, bool left) const {
  // Seen from the field, the sky-blue goal's left post is at positive y.
  const double side = color == GoalColor::yellow ? -1 : 1;
  return onRobot({side * field_.xGroundline, (left ? side : -side) * field_.yGoal});
}

int VisionTruth::pixels(Kind kind, std::size_t number) const {
  int sum = 0;
  for (std::size_t i = 0; i < objects_.size(); ++i)
    if (objects_[i].kind == kind && objects_[i].number == number) sum += counts_[i];
  return sum;
}

const VisionTruth::Object& VisionTruth::objectAt(int x, int y) const {
  const auto i = static_cast<std::size_t>(y * view_->image.info.width + x);
  return objects_[static_cast<std::size_t>(view_->truth.geoms[i] + 1)];
}

bool VisionTruth::shows(const Vector2d& inImage, Kind kind, std::size_t number) const {
  constexpr int reach = 2;  // Pixels.
  const int x0 = static_cast<int>(std::floor(inImage.x()));
  const int y0 = static_cast<int>(std::floor(inImage.y()));
  for (int y = y0 - reach; y <= y0 + reach; ++y)
    for (int x = x0 - reach; x <= x0 + reach; ++x) {
      if (!view_->image.info.contains(x, y)) continue;
      const Object& object = objectAt(x, y);
      if (object.kind == kind && object.number == number) return true;
    }
  return false;
}

std::optional<VisionTruth::Kind> VisionTruth::at(const Vector2d& onGround) const {
  const Vector3d ray = Vector3d{onGround.x(), onGround.y(), 0} - camera().pose.translation;
  if (camera().pose.rotation.col(0).dot(ray) <= 0) return std::nullopt;
  const Vector2d p = pointIn(camera(), ray);
  if (!view_->image.info.contains(p.x(), p.y())) return std::nullopt;
  return objectAt(static_cast<int>(p.x()), static_cast<int>(p.y())).kind;
}

}  // namespace gt
