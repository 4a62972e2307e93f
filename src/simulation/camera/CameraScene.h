#pragma once
#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "representations/perception/ColorTable64.h"

namespace gt {

/// A color as the camera measures it, y in the lowest byte, then cb, cr and the color class.
using PackedColor = std::uint32_t;

/// Full range YCbCr (JPEG) of a color, red, green and blue in 0..1.
PackedColor packColor(const Eigen::Vector3f& rgb, ColorClass colorClass);

/// The color class that a person would give a color, red, green and blue in 0..1.
ColorClass classOfRgb(const Eigen::Vector3f& rgb);

/// Upper bound (m) of the distance from any point of a geom to the origin of the body at the root
/// of its chain, for all joint angles; infinite for planes and behind slide joints.
double reachFromRoot(const mjModel& model, int geom);

/// The forms that the cameras draw; spheres are drawn as ellipsoids.
enum class CameraForm : std::uint8_t { plane, box, ellipsoid, cylinder, capsule, mesh };

/// The data of one MuJoCo geom that the cameras need beside its pose. Meters.
struct CameraShape {
  static constexpr int shadeCount = 32;

  int geom = 0;
  int body = 0;
  CameraForm form = CameraForm::box;
  bool decal = false;  ///< Lies flat on the floor; painted in order, without depth.
  Eigen::Vector3f size = Eigen::Vector3f::Zero();
  float reach = 0;  ///< Radius of its bounding sphere; infinite for planes.
  int firstFace = 0, faceCount = 0;
  std::array<PackedColor, shadeCount> shades{};  ///< From turned away from the light to facing it.
};

/// Shapes that are culled together: all that stand still, or those of one robot.
struct CameraCluster {
  int body = 0;     ///< Its root body, the center of its bounding sphere.
  float reach = 0;  ///< Radius of its bounding sphere (m); infinite for what stands still.
  int first = 0, count = 0;
};

/// The immutable part of what the cameras see, prepared from a MuJoCo model and shared by all
/// robots and threads. Provided by the simulator, used by the CameraRenderer.
///
/// A geom's color class is the part of its material's name up to the first dot (behind the last
/// slash), otherwise it is guessed from its color. Geoms of group 1 are decals, those of group 5
/// and transparent ones are not seen. The model must outlive the scene.
///
/// A geom's detail level is the first number of its `user` in MJCF, 0 without one (report 5.1.2):
/// views leave out what is above their own level, 0 to 10; robots' cameras see all.
class CameraScene {
 public:
  struct Face {
    std::array<Eigen::Vector3f, 3> points;
    Eigen::Vector3f normal;
  };

  static constexpr int mostDetail = 10;

  explicit CameraScene(const mjModel& model,
                       const Eigen::Vector3f& backgroundRgb = {0.46f, 0.43f, 0.41f},
                       int detail = mostDetail);

  const std::vector<CameraShape>& shapes() const { return shapes_; }
  const std::vector<CameraCluster>& clusters() const { return clusters_; }
  const std::vector<Face>& faces() const { return faces_; }
  const mjModel& model() const { return *model_; }
  PackedColor background() const { return background_; }
  /// The color class that a geom is drawn with; noColor for geoms that are not seen.
  ColorClass classOf(int geom) const { return classes_[static_cast<std::size_t>(geom)]; }

 private:
  void addShape(const mjModel& model, int geom);
  void addFaces(const mjModel& model, int mesh, CameraShape& shape);
  void addClusters(const mjModel& model);

  const mjModel* model_;
  std::vector<CameraShape> shapes_;
  std::vector<CameraCluster> clusters_;
  std::vector<Face> faces_;
  std::vector<ColorClass> classes_;
  PackedColor background_;
};

}  // namespace gt
