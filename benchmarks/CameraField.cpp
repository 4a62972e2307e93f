#include "CameraField.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "Parts.h"
#include "base/Random.h"
#include "simulation/scene/SceneModel.h"

namespace gt {

const CameraField& CameraField::get() {
  static const CameraField field;
  return field;
}

CameraField::CameraField() {
  const auto scene = loadScene(dataRoot().path("scenes/match.scene"));
  if (!scene) throw std::runtime_error(scene.error().text());
  auto model = composeModel(*scene);
  if (!model) throw std::runtime_error(model.error().text());
  model_ = std::move(*model);
  data_ = makeData(*model_);
  for (const SceneRobot& robot : scene->robots) place(robot);
  mj_forward(model_.get(), data_.get());
  Random random{1};
  for (int site = 0; site < model_->nsite; ++site) {
    const std::string name = model_->names + model_->name_siteadr[site];
    if (name.size() < 7 || name.substr(name.size() - 7) != "/camera") continue;
    for (int i = 0; i < 16; ++i) {
      CameraView view;
      view.last = sitePose(*data_, site);
      view.hiddenBody = model_->site_bodyid[site];
      const double pan = random.uniform(-1.2, 1.2), tilt = random.uniform(-0.2, 0.3);
      view.last.rotation = view.last.rotation * rotationZ(pan) * rotationY(tilt);
      view.first = view.last;
      view.first.rotation = rotationZ(random.uniform(-0.1, 0.1)) * view.last.rotation;
      views_.push_back(view);
    }
  }
}

void CameraField::place(const SceneRobot& robot) {
  const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, (robot.name + "/pose").c_str());
  if (joint < 0) throw std::runtime_error(robot.name + " has no joint named pose");
  mjtNum* pose = data_->qpos + model_->jnt_qposadr[joint];
  pose[0] = robot.x / 1000;
  pose[1] = robot.y / 1000;
  pose[3] = std::cos(robot.pose().rotation / 2);
  pose[6] = std::sin(robot.pose().rotation / 2);
}

}  // namespace gt
