#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "debug/Drawing.h"
#include "simulation/world/World.h"
#include "workbench/space/OrbitCamera.h"

namespace gt {

/// How a scene's geoms are drawn.
struct GlStyle {
  bool wireFrames = false;
  bool transparent = false;             ///< All that moves.
  bool contacts = false;                ///< Where bodies touch, with forces.
  std::array<bool, mjNGROUP> groups{};  ///< Groups of geoms that are drawn.
};

/// What a ray meets.
struct Picked {
  int geom = 0;    ///< Of the model.
  Vector3d point;  ///< mm on the field
};

/// What a `GlView` draws: geoms of MuJoCo, with the model that their meshes and materials belong
/// to. Made on the session's thread, drawn on the window's; not by both at a time.
class GlScene {
 public:
  explicit GlScene(std::shared_ptr<const mjModel> model);
  ~GlScene();
  GlScene(const GlScene&) = delete;
  GlScene& operator=(const GlScene&) = delete;

  /// Draws a world, whose model is equal to this one's, instead of what was drawn before.
  void show(const World& world, const GlStyle& style);
  /// Draws nothing; adds light.
  void clear();
  /// Leaves out all geoms of the model but those that are wanted.
  void keep(const std::function<bool(int geom)>& wanted);
  /// Moves all that is drawn on the field.
  void move(const Pose2D& from, const Pose2D& to);
  /// Draws the geoms of the model from `first` to before `last` once more, moved on the field and
  /// nearly transparent.
  void addGhost(int first, int last, const Pose2D& from, const Pose2D& to);
  /// Adds a shape: half its extents and its place in mm.
  void add(mjtGeom shape, const Vector3d& size, const Vector3d& at, const Color& color,
           const Matrix3d& rotation = Matrix3d::Identity());
  /// Adds a line of some width between two points (mm).
  void addLine(const Vector3d& from, const Vector3d& to, double width, const Color& color);

  /// The first geom of the model that a ray meets, of those that are drawn.
  std::optional<Picked> pick(const Ray& ray) const;

  const std::shared_ptr<const mjModel>& model() const { return model_; }
  mjvScene& geoms() { return scene_; }

 private:
  std::shared_ptr<const mjModel> model_;
  mjvScene scene_;
};

/// A copy of a world's model to draw, without what drawing in a window does not need.
std::shared_ptr<const mjModel> modelToDraw(const mjModel& model);

}  // namespace gt
