#include "simulation/camera/CameraScene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "simulation/camera/GeomColor.h"

namespace gt {
namespace {

constexpr int decalGroup = 1;
constexpr float infinitePlane = 30;

Eigen::Vector3f vectorAt(const mjtNum* values, int i) {
  return {static_cast<float>(values[3 * i]), static_cast<float>(values[3 * i + 1]),
          static_cast<float>(values[3 * i + 2])};
}

ColorClass classOf(const mjModel& model, int geom) {
  const float* rgba = rgbaOf(model, geom);
  const ColorClass guess = classOfRgb({rgba[0], rgba[1], rgba[2]});
  const int material = model.geom_matid[geom];
  if (material < 0) return guess;
  std::string_view name = model.names + model.name_matadr[material];
  name = name.substr(name.rfind('/') + 1);
  return enumValue<ColorClass>(name.substr(0, name.find('.'))).value_or(guess);
}

std::optional<CameraForm> formOf(const mjModel& model, int geom) {
  switch (model.geom_type[geom]) {
    case mjGEOM_PLANE:
      return CameraForm::plane;
    case mjGEOM_BOX:
      return CameraForm::box;
    case mjGEOM_SPHERE:
    case mjGEOM_ELLIPSOID:
      return CameraForm::ellipsoid;
    case mjGEOM_CYLINDER:
      return CameraForm::cylinder;
    case mjGEOM_CAPSULE:
      return CameraForm::capsule;
    case mjGEOM_MESH:
      return CameraForm::mesh;
    default:
      return std::nullopt;
  }
}

double detailOf(const mjModel& model, int geom) {
  return model.nuser_geom > 0 ? model.geom_user[model.nuser_geom * geom] : 0;
}

bool standsStill(const mjModel& model, int body) {
  return model.body_weldid[body] == 0;
}

/// The place in the order of drawing: floors, what lies on them, what stands, then the robots.
int orderOf(const mjModel& model, const CameraShape& shape) {
  if (!standsStill(model, shape.body)) return 3 + model.body_rootid[shape.body];
  if (shape.form == CameraForm::plane) return 0;
  return shape.decal ? 1 : 2;
}

}  // namespace

double reachFromRoot(const mjModel& model, int geom) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto length = [](const mjtNum* v) { return std::hypot(v[0], v[1], v[2]); };
  if (model.geom_type[geom] == mjGEOM_PLANE) return infinity;
  int body = model.geom_bodyid[geom];
  double reach = length(model.geom_pos + 3 * geom) + model.geom_rbound[geom];
  for (; body != model.body_rootid[body]; body = model.body_parentid[body]) {
    reach += length(model.body_pos + 3 * body);
    for (int i = 0; i < model.body_jntnum[body]; ++i) {
      const int joint = model.body_jntadr[body] + i;
      if (model.jnt_type[joint] == mjJNT_SLIDE || model.jnt_type[joint] == mjJNT_FREE)
        return infinity;
      reach += 2 * length(model.jnt_pos + 3 * joint);  // it turns round an anchor beside it
    }
  }
  return reach;
}

PackedColor packColor(const Eigen::Vector3f& rgb, ColorClass colorClass) {
  const Eigen::Vector3f c = 255 * rgb;
  const auto byte = [](float value) {
    return static_cast<PackedColor>(std::clamp(std::lround(value), 0l, 255l));
  };
  return byte(0.299f * c.x() + 0.587f * c.y() + 0.114f * c.z()) |
         byte(128 - 0.168736f * c.x() - 0.331264f * c.y() + 0.5f * c.z()) << 8 |
         byte(128 + 0.5f * c.x() - 0.418688f * c.y() - 0.081312f * c.z()) << 16 |
         static_cast<PackedColor>(colorClass) << 24;
}

ColorClass classOfRgb(const Eigen::Vector3f& rgb) {
  const float high = rgb.maxCoeff(), low = rgb.minCoeff(), chroma = high - low;
  if (chroma < 0.25f * high || high < 0.12f)
    return high > 0.75f ? ColorClass::white : high > 0.25f ? ColorClass::gray : ColorClass::black;
  float hue = rgb.x() == high   ? (rgb.y() - rgb.z()) / chroma
              : rgb.y() == high ? 2 + (rgb.z() - rgb.x()) / chroma
                                : 4 + (rgb.x() - rgb.y()) / chroma;
  hue = 60 * (hue < 0 ? hue + 6 : hue);
  const bool pale = chroma < 0.7f * high;
  if (hue < 12 || hue >= (pale ? 355 : 340)) return ColorClass::red;
  if (hue < 42) return ColorClass::orange;
  if (hue < 70) return ColorClass::yellow;
  if (hue < 170) return ColorClass::green;
  if (hue < 220) return ColorClass::skyblue;
  return hue < 280 ? ColorClass::blue : ColorClass::pink;
}

CameraScene::CameraScene(const mjModel& model, const Eigen::Vector3f& backgroundRgb, int detail)
    : model_(&model),
      classes_(static_cast<std::size_t>(model.ngeom), ColorClass::noColor),
      background_(packColor(backgroundRgb, ColorClass::noColor)) {
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (model.geom_group[geom] != hiddenGroup && rgbaOf(model, geom)[3] >= 0.5f &&
        detailOf(model, geom) <= detail)
      addShape(model, geom);
  std::stable_sort(shapes_.begin(), shapes_.end(), [&](const auto& a, const auto& b) {
    return orderOf(model, a) < orderOf(model, b);
  });
  addClusters(model);
}

void CameraScene::addShape(const mjModel& model, int geom) {
  const auto form = formOf(model, geom);
  if (!form) return;
  CameraShape shape;
  shape.geom = geom;
  shape.body = model.geom_bodyid[geom];
  shape.form = *form;
  shape.decal = model.geom_group[geom] == decalGroup && standsStill(model, shape.body);
  shape.size = vectorAt(model.geom_size, geom);
  shape.reach = static_cast<float>(model.geom_rbound[geom]);
  if (model.geom_type[geom] == mjGEOM_SPHERE) shape.size.setConstant(shape.size.x());
  if (shape.form == CameraForm::plane) {
    for (int i = 0; i < 2; ++i)
      if (shape.size[i] <= 0) shape.size[i] = infinitePlane;
    shape.reach = std::numeric_limits<float>::infinity();
  }
  if (shape.form == CameraForm::mesh) addFaces(model, model.geom_dataid[geom], shape);

  const float* rgba = rgbaOf(model, geom);
  const ColorClass colorClass = gt::classOf(model, geom);
  classes_[static_cast<std::size_t>(geom)] = colorClass;
  for (int i = 0; i < CameraShape::shadeCount; ++i) {
    const float light = 2.0f * static_cast<float>(i) / (CameraShape::shadeCount - 1) - 1;
    const Eigen::Vector3f rgb{rgba[0], rgba[1], rgba[2]};
    shape.shades[static_cast<std::size_t>(i)] = packColor((0.8f + 0.2f * light) * rgb, colorClass);
  }
  shapes_.push_back(shape);
}

void CameraScene::addFaces(const mjModel& model, int mesh, CameraShape& shape) {
  shape.firstFace = static_cast<int>(faces_.size());
  shape.faceCount = model.mesh_facenum[mesh];
  for (int i = 0; i < shape.faceCount; ++i) {
    Face face;
    for (int k = 0; k < 3; ++k) {
      const int vertex = model.mesh_face[3 * (model.mesh_faceadr[mesh] + i) + k];
      const float* p = model.mesh_vert + 3 * (model.mesh_vertadr[mesh] + vertex);
      face.points[static_cast<std::size_t>(k)] = {p[0], p[1], p[2]};
    }
    face.normal =
        (face.points[1] - face.points[0]).cross(face.points[2] - face.points[0]).normalized();
    faces_.push_back(face);
  }
}

void CameraScene::addClusters(const mjModel& model) {
  int current = -1;
  for (int i = 0; i < static_cast<int>(shapes_.size()); ++i) {
    const CameraShape& shape = shapes_[static_cast<std::size_t>(i)];
    const bool still = standsStill(model, shape.body);
    const int root = still ? 0 : model.body_rootid[shape.body];
    if (root != current) clusters_.push_back({root, 0, i, 0});
    current = root;
    CameraCluster& cluster = clusters_.back();
    ++cluster.count;
    cluster.reach =
        still ? std::numeric_limits<float>::infinity()
              : std::max(cluster.reach, static_cast<float>(reachFromRoot(model, shape.geom)));
  }
}

}  // namespace gt
