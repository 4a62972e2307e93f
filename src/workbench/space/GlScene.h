#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "debug/Drawing.h"
#include "simulation/world/World.h"
#include "workbench/space/OrbitCamera.h"

namespace gt {

/// The style in which a scene's geoms are drawn.
struct GlStyle {
  bool wireFrames = false;
  bool transparent = false;             ///< Whether all that moves is transparent.
  bool contacts = false;                ///< Whether contacts are drawn, with forces.
  std::array<bool, mjNGROUP> groups{};  ///< Groups of geoms that are drawn.
};

/// A point of a geom that a ray meets.
struct Picked {
  int geom = 0;    ///< Of the model.
  Vector3d point;  ///< mm on the field
};

/// The content of a `GlView`: geoms of MuJoCo, with the model that their meshes and materials
/// belong to. Made on the session's thread, drawn on the window's, but not by both at a time.
class GlScene {
 public:
  explicit GlScene(std::shared_ptr<const mjModel> model);
  ~GlScene();
  GlScene(const GlScene&) = delete;
  GlScene& operator=(const GlScene&) = delete;

  /// Replaces the content by a world, whose model must be equal to this one's.
  void show(const World& world, const GlStyle& style);
  /// Removes all geoms; adds light.
  void clear();
  /// Removes all geoms of the model for which `wanted` returns false.
  void keep(const std::function<bool(int geom)>& wanted);
  /// Moves all geoms on the field, as a body that moves from one pose to another (mm, rad).
  void move(const Pose2D& from, const Pose2D& to);
  /// Draws the geoms of the model from `first` to before `last` once more, moved on the field and
  /// nearly transparent.
  void addGhost(int first, int last, const Pose2D& from, const Pose2D& to);
  /// Adds a shape; `size` is half of its extents, `at` its place on the field (mm).
  void add(mjtGeom shape, const Vector3d& size, const Vector3d& at, const Color& color,
           const Matrix3d& rotation = Matrix3d::Identity());
  /// Adds a line between two points on the field (mm).
  void addLine(const Vector3d& from, const Vector3d& to, double width, const Color& color);

  /// The first geom of the model that a ray meets, of those that are drawn.
  std::optional<Picked> pick(const Ray& ray) const;

  const std::shared_ptr<const mjModel>& model() const { return model_; }
  mjvScene& geoms() { return scene_; }

 private:
  std::shared_ptr<const mjModel> model_;
  mjvScene scene_;
};

/// A copy of a world's model for drawing, without the data that drawing in a window does not need.
std::shared_ptr<const mjModel> modelToDraw(const mjModel& model);

}  // namespace gt
