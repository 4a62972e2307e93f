#pragma once
#include <mujoco/mujoco.h>

#include <vector>

#include "simulation/MuJoCo.h"
#include "simulation/Scene.h"
#include "simulation/camera/CameraView.h"

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
