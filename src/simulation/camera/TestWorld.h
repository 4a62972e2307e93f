#pragma once
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <memory>
#include <string>

#include "base/Random.h"
#include "simulation/camera/CameraRenderer.h"

namespace gt {

/// A MuJoCo world for tests of the cameras: a model from a text or a file, in its first state.
class TestWorld {
 public:
  static TestWorld fromBodies(const std::string& worldbody, const std::string& assets = "") {
    const std::string text =
        "<mujoco><asset>" + assets + "</asset><worldbody>" + worldbody + "</worldbody></mujoco>";
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    const char* name = "test.xml";
    mj_makeEmptyFileVFS(files.get(), name, static_cast<int>(text.size()));
    const int file = mj_findFileVFS(files.get(), name);
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[file]));
    TestWorld world{name, files.get()};
    mj_deleteVFS(files.get());
    return world;
  }
  static TestWorld fromFile(const std::string& path) { return TestWorld{path, nullptr}; }

  mjModel& model() { return *model_; }
  mjData& data() { return *data_; }
  int geom(const char* name) const { return mj_name2id(model_.get(), mjOBJ_GEOM, name); }
  const CameraScene& scene() const { return *scene_; }

  /// Takes an image with an own renderer.
  Image picture(const CameraView& view, const CameraEffects& effects = CameraEffects::none(),
                ImageTruth* truth = nullptr, std::uint64_t seed = 1) const {
    CameraRenderer renderer{*scene_};
    Image image;
    renderer.render(*data_, view, effects, seed, image, truth);
    return image;
  }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };

  TestWorld(const std::string& path, const mjVFS* files) {
    char error[1000] = "";
    model_.reset(mj_loadXML(path.c_str(), files, error, sizeof error));
    EXPECT_TRUE(model_) << error;
    data_.reset(mj_makeData(model_.get()));
    mj_forward(model_.get(), data_.get());
    scene_ = std::make_unique<CameraScene>(*model_);
  }

  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
  std::unique_ptr<CameraScene> scene_;
};

/// The view of a camera that stands still; mm, angles in rad.
inline CameraView viewFrom(const Vector3d& position, double pan = 0, double tilt = 0,
                           double roll = 0) {
  CameraView view;
  view.last.translation = position;
  view.last.rotation = rotationZ(pan) * rotationY(-tilt) * rotationX(roll);
  view.first = view.last;
  return view;
}

/// The camera's pose when a row is exposed (a real number: the row's center is 0.5 behind its
/// number), computed in another way than the renderer does.
inline Pose3D poseAtRow(const CameraView& view, double row) {
  const double s = (row - 0.5) / (view.info.height - 1);
  const Eigen::AngleAxisd turn{view.first.rotation.transpose() * view.last.rotation};
  Pose3D pose;
  pose.rotation =
      view.first.rotation * Eigen::AngleAxisd{s * turn.angle(), turn.axis()}.toRotationMatrix();
  pose.translation = (1 - s) * view.first.translation + s * view.last.translation;
  return pose;
}

/// The place in the image (pixels) where a still camera sees a point on the field (mm).
inline Vector2d seenAt(const CameraView& view, const Vector3d& point) {
  return view.info.project(view.last.inverse() * point);
}

}  // namespace gt
