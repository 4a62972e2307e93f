#include "simulation/scene/ModelRows.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace gt {
namespace {

using K = ModelKind;

constexpr std::array kindCounts{
    std::pair{K::body, &mjModel::nbody},    std::pair{K::joint, &mjModel::njnt},
    std::pair{K::dof, &mjModel::nv},        std::pair{K::position, &mjModel::nq},
    std::pair{K::geom, &mjModel::ngeom},    std::pair{K::site, &mjModel::nsite},
    std::pair{K::camera, &mjModel::ncam},   std::pair{K::light, &mjModel::nlight},
    std::pair{K::material, &mjModel::nmat}, std::pair{K::pair, &mjModel::npair},
    std::pair{K::equality, &mjModel::neq},  std::pair{K::tendon, &mjModel::ntendon},
    std::pair{K::actuator, &mjModel::nu},   std::pair{K::sensor, &mjModel::nsensor}};
static_assert(kindCounts.size() == enumCount<ModelKind>);

int positionsOf(const mjModel& model, int joint) {
  const int end = joint + 1 < model.njnt ? model.jnt_qposadr[joint + 1] : model.nq;
  return end - model.jnt_qposadr[joint];
}

}  // namespace

int countOf(const mjModel& model, ModelKind kind) {
  return model.*kindCounts[static_cast<std::size_t>(kind)].second;
}

std::optional<ModelKind> modelKindOf(mjtObj type) {
  switch (type) {
    case mjOBJ_BODY:
    case mjOBJ_XBODY:
      return K::body;
    case mjOBJ_JOINT:
      return K::joint;
    case mjOBJ_GEOM:
      return K::geom;
    case mjOBJ_SITE:
      return K::site;
    case mjOBJ_CAMERA:
      return K::camera;
    case mjOBJ_TENDON:
      return K::tendon;
    default:
      return std::nullopt;
  }
}

bool ModelRows::has(ModelKind kind, int row) const {
  return std::ranges::binary_search((*this)[kind], row);
}

ModelRows ModelRows::all(const mjModel& model) {
  ModelRows rows;
  for (const auto& [kind, count] : kindCounts) {
    rows[kind].resize(static_cast<std::size_t>(model.*count));
    std::iota(rows[kind].begin(), rows[kind].end(), 0);
  }
  return rows;
}

ModelRows ModelRows::below(const mjModel& model, int body) {
  ModelRows rows;
  for (int b = body; b < model.nbody; ++b)
    if (b == body || rows.has(K::body, model.body_parentid[b])) rows[K::body].push_back(b);
  const auto take = [&](K kind, int count, const int* bodies) {
    for (int i = 0; i < count; ++i)
      if (rows.has(K::body, bodies[i])) rows[kind].push_back(i);
  };
  take(K::joint, model.njnt, model.jnt_bodyid);
  take(K::dof, model.nv, model.dof_bodyid);
  take(K::geom, model.ngeom, model.geom_bodyid);
  take(K::site, model.nsite, model.site_bodyid);
  take(K::camera, model.ncam, model.cam_bodyid);
  take(K::light, model.nlight, model.light_bodyid);
  for (const int joint : rows[K::joint])
    for (int i = 0; i < positionsOf(model, joint); ++i)
      rows[K::position].push_back(model.jnt_qposadr[joint] + i);
  return rows;
}

NumberCopy::NumberCopy(const mjModel& alone, const ModelRows& rows, mjModel& joined,
                       const OfModelKinds<int>& first, std::string prefix)
    : alone_{alone}, rows_{rows}, joined_{joined}, first_{first}, prefix_{std::move(prefix)} {}

bool NumberCopy::fits() const {
  for (const auto& [kind, count] : kindCounts)
    if (first_[kind] + static_cast<int>(rows_[kind].size()) > joined_.*count) return false;
  return sameParents() && sameNames(K::body, mjOBJ_BODY) && sameNames(K::joint, mjOBJ_JOINT) &&
         sameNames(K::geom, mjOBJ_GEOM) && sameNames(K::site, mjOBJ_SITE) &&
         sameNames(K::camera, mjOBJ_CAMERA) && sameNames(K::light, mjOBJ_LIGHT) &&
         sameNames(K::equality, mjOBJ_EQUALITY) && sameNames(K::tendon, mjOBJ_TENDON) &&
         sameNames(K::actuator, mjOBJ_ACTUATOR) && sameNames(K::sensor, mjOBJ_SENSOR) &&
         same(K::body, &mjModel::body_jntnum) && same(K::body, &mjModel::body_geomnum) &&
         same(K::joint, &mjModel::jnt_type) && same(K::geom, &mjModel::geom_type) &&
         same(K::site, &mjModel::site_type) && same(K::equality, &mjModel::eq_type) &&
         same(K::tendon, &mjModel::tendon_num) && same(K::sensor, &mjModel::sensor_type);
}

bool NumberCopy::copy() {
  copyBodies();
  copyJoints();
  copyShapes();
  copyViews();
  copyOthers();
  return changed_;
}

/// Copies the rows of an array. Its rows may be wider in one of the models: then the rest is 0.
template <typename T>
void NumberCopy::column(ModelKind kind, T* mjModel::*array, int width, int widthAlone) {
  const auto common = static_cast<std::size_t>(std::min(width, widthAlone));
  int row = first_[kind];
  for (const int from : rows_[kind]) {
    T* into = joined_.*array + static_cast<std::ptrdiff_t>(row++) * width;
    const T* source = alone_.*array + static_cast<std::ptrdiff_t>(from) * widthAlone;
    if (std::memcmp(into, source, common * sizeof(T)) == 0) continue;
    std::memcpy(into, source, common * sizeof(T));
    changed_ = true;
  }
}

template <typename T>
bool NumberCopy::same(ModelKind kind, T* mjModel::*array) const {
  int row = first_[kind];
  return std::ranges::all_of(
      rows_[kind], [&](int from) { return (alone_.*array)[from] == (joined_.*array)[row++]; });
}

bool NumberCopy::sameNames(ModelKind kind, mjtObj type) const {
  int row = first_[kind];
  return std::ranges::all_of(rows_[kind], [&](int from) {
    const bool isWorld = type == mjOBJ_BODY && from == 0;
    const std::string alone = nameOf(alone_, type, from), joined = nameOf(joined_, type, row++);
    return joined == (alone.empty() || isWorld ? alone : prefix_ + alone);
  });
}

bool NumberCopy::sameParents() const {
  const std::vector<int>& bodies = rows_[K::body];
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    const auto parent = std::ranges::lower_bound(bodies, alone_.body_parentid[bodies[i]]);
    if (parent == bodies.end() || joined_.body_parentid[first_[K::body] + static_cast<int>(i)] !=
                                      first_[K::body] + (parent - bodies.begin()))
      return false;
  }
  return true;
}

void NumberCopy::copyBodies() {
  using M = mjModel;
  for (const auto& [array, width] : {std::pair{&M::body_pos, 3},
                                     {&M::body_quat, 4},
                                     {&M::body_ipos, 3},
                                     {&M::body_iquat, 4},
                                     {&M::body_mass, 1},
                                     {&M::body_inertia, 3}})
    column(K::body, array, width);
  column(K::body, &M::body_simple);
  column(K::body, &M::body_sameframe);
  column(K::body, &M::body_user, joined_.nuser_body, alone_.nuser_body);
}

void NumberCopy::copyJoints() {
  using M = mjModel;
  column(K::position, &M::qpos0);
  column(K::position, &M::qpos_spring);
  column(K::joint, &M::jnt_limited);
  column(K::joint, &M::jnt_group);
  for (const auto& [array, width] : {std::pair{&M::jnt_solref, mjNREF},
                                     {&M::jnt_solimp, mjNIMP},
                                     {&M::jnt_pos, 3},
                                     {&M::jnt_axis, 3},
                                     {&M::jnt_stiffness, 1},
                                     {&M::jnt_range, 2},
                                     {&M::jnt_margin, 1}})
    column(K::joint, array, width);
  column(K::joint, &M::jnt_user, joined_.nuser_jnt, alone_.nuser_jnt);
  column(K::dof, &M::dof_simplenum);
  for (const auto& [array, width] : {std::pair{&M::dof_solref, mjNREF},
                                     {&M::dof_solimp, mjNIMP},
                                     {&M::dof_frictionloss, 1},
                                     {&M::dof_armature, 1},
                                     {&M::dof_damping, 1}})
    column(K::dof, array, width);
}

void NumberCopy::copyShapes() {
  using M = mjModel;
  for (const auto array :
       {&M::geom_contype, &M::geom_conaffinity, &M::geom_condim, &M::geom_group, &M::geom_priority})
    column(K::geom, array);
  column(K::geom, &M::geom_sameframe);
  for (const auto& [array, width] : {std::pair{&M::geom_solmix, 1},
                                     {&M::geom_solref, mjNREF},
                                     {&M::geom_solimp, mjNIMP},
                                     {&M::geom_size, 3},
                                     {&M::geom_rbound, 1},
                                     {&M::geom_pos, 3},
                                     {&M::geom_quat, 4},
                                     {&M::geom_friction, 3},
                                     {&M::geom_margin, 1},
                                     {&M::geom_gap, 1},
                                     {&M::geom_fluid, mjNFLUID}})
    column(K::geom, array, width);
  column(K::geom, &M::geom_user, joined_.nuser_geom, alone_.nuser_geom);
  column(K::geom, &M::geom_rgba, 4);
  column(K::site, &M::site_group);
  column(K::site, &M::site_sameframe);
  column(K::site, &M::site_size, 3);
  column(K::site, &M::site_pos, 3);
  column(K::site, &M::site_quat, 4);
  column(K::site, &M::site_user, joined_.nuser_site, alone_.nuser_site);
  column(K::site, &M::site_rgba, 4);
}

void NumberCopy::copyViews() {
  using M = mjModel;
  column(K::camera, &M::cam_mode);
  column(K::camera, &M::cam_pos, 3);
  column(K::camera, &M::cam_quat, 4);
  column(K::camera, &M::cam_fovy);
  column(K::camera, &M::cam_ipd);
  column(K::camera, &M::cam_user, joined_.nuser_cam, alone_.nuser_cam);
  column(K::light, &M::light_mode);
  for (const auto array : {&M::light_directional, &M::light_castshadow, &M::light_active})
    column(K::light, array);
  column(K::light, &M::light_pos, 3);
  column(K::light, &M::light_dir, 3);
  for (const auto& [array, width] : {std::pair{&M::light_attenuation, 3},
                                     {&M::light_cutoff, 1},
                                     {&M::light_exponent, 1},
                                     {&M::light_ambient, 3},
                                     {&M::light_diffuse, 3},
                                     {&M::light_specular, 3}})
    column(K::light, array, width);
  column(K::material, &M::mat_texuniform);
  for (const auto& [array, width] : {std::pair{&M::mat_texrepeat, 2},
                                     {&M::mat_emission, 1},
                                     {&M::mat_specular, 1},
                                     {&M::mat_shininess, 1},
                                     {&M::mat_reflectance, 1},
                                     {&M::mat_rgba, 4}})
    column(K::material, array, width);
}

void NumberCopy::copyOthers() {
  using M = mjModel;
  column(K::pair, &M::pair_dim);
  for (const auto& [array, width] : {std::pair{&M::pair_solref, mjNREF},
                                     {&M::pair_solimp, mjNIMP},
                                     {&M::pair_margin, 1},
                                     {&M::pair_gap, 1},
                                     {&M::pair_friction, 5}})
    column(K::pair, array, width);
  column(K::equality, &M::eq_active);
  for (const auto& [array, width] :
       {std::pair{&M::eq_solref, mjNREF}, {&M::eq_solimp, mjNIMP}, {&M::eq_data, mjNEQDATA}})
    column(K::equality, array, width);
  column(K::tendon, &M::tendon_limited);
  column(K::tendon, &M::tendon_group);
  for (const auto& [array, width] : {std::pair{&M::tendon_width, 1},
                                     {&M::tendon_solref_lim, mjNREF},
                                     {&M::tendon_solimp_lim, mjNIMP},
                                     {&M::tendon_solref_fri, mjNREF},
                                     {&M::tendon_solimp_fri, mjNIMP},
                                     {&M::tendon_range, 2},
                                     {&M::tendon_margin, 1},
                                     {&M::tendon_stiffness, 1},
                                     {&M::tendon_damping, 1},
                                     {&M::tendon_frictionloss, 1},
                                     {&M::tendon_lengthspring, 1}})
    column(K::tendon, array, width);
  column(K::tendon, &M::tendon_user, joined_.nuser_tendon, alone_.nuser_tendon);
  column(K::tendon, &M::tendon_rgba, 4);
  for (const auto array :
       {&M::actuator_ctrllimited, &M::actuator_forcelimited, &M::actuator_actlimited})
    column(K::actuator, array);
  for (const auto& [array, width] : {std::pair{&M::actuator_dynprm, mjNDYN},
                                     {&M::actuator_gainprm, mjNGAIN},
                                     {&M::actuator_biasprm, mjNBIAS},
                                     {&M::actuator_ctrlrange, 2},
                                     {&M::actuator_forcerange, 2},
                                     {&M::actuator_actrange, 2},
                                     {&M::actuator_gear, 6},
                                     {&M::actuator_cranklength, 1},
                                     {&M::actuator_lengthrange, 2}})
    column(K::actuator, array, width);
  column(K::actuator, &M::actuator_user, joined_.nuser_actuator, alone_.nuser_actuator);
  column(K::sensor, &M::sensor_cutoff);
  column(K::sensor, &M::sensor_noise);
  column(K::sensor, &M::sensor_user, joined_.nuser_sensor, alone_.nuser_sensor);
}

}  // namespace gt
