#pragma once
#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"

namespace gt {

/// Frees MuJoCo's objects.
struct MuJoCoDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, MuJoCoDeleter>;
using ModelData = std::unique_ptr<mjData, MuJoCoDeleter>;

/// Compiles an MJCF text. Errors of MuJoCo are returned as an `Error` in `file`; none of them ends
/// the process.
Result<Model> compileModel(const std::string& mjcf, const std::string& file);

/// A deep copy of a model.
Model copyModel(const mjModel& model);

/// Creates data for a model, in the model's default state.
ModelData makeData(const mjModel& model);

/// A position of MuJoCo (meters) in millimeters.
inline Vector3d fromMuJoCo(const mjtNum* position) {
  return 1000 * Eigen::Map<const Vector3d>(position);
}

/// A rotation of MuJoCo (9 numbers, row by row).
inline Matrix3d rotationFromMuJoCo(const mjtNum* matrix) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix);
}

/// The name of an object of the model; empty if it has none.
std::string nameOf(const mjModel& model, mjtObj type, int id);

/// The numbers of a custom field of the model (MJCF's `numeric`); empty if there is no such field.
std::vector<double> customNumbers(const mjModel& model, const std::string& name);

/// The pose of a site in the world (mm).
inline Pose3D sitePose(const mjData& data, int site) {
  return {rotationFromMuJoCo(data.site_xmat + 9 * site), fromMuJoCo(data.site_xpos + 3 * site)};
}

}  // namespace gt
