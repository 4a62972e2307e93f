#pragma once
#include <mujoco/mujoco.h>

#include <vector>

#include "simulation/camera/CameraView.h"
#include "simulation/scene/MuJoCo.h"
#include "simulation/scene/Scene.h"

namespace gt {

/// The eight robots of scenes/match.scene, in their places, looking around so that the horizon is
/// mostly seen.
class CameraField {
 public:
  /// One for all benchmarks: its model is large.
  static const CameraField& get();

  const mjModel& model() const { return *model_; }
  mjData& data() const { return *data_; }
  const std::vector<CameraView>& views() const { return views_; }

 private:
  CameraField();
  void place(const SceneRobot& robot);

  Model model_;
  ModelData data_;
  std::vector<CameraView> views_;
};

}  // namespace gt
