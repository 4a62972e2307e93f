#include "simulation/scene/FieldSensorModel.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"

namespace gt {
namespace {

constexpr double farthest = 10;  // m, of a whisker without a cutoff
constexpr int receptorRays = 5;  // in each direction

/// The kinds that MJCF knows: the unit of their values in MuJoCo's units, and the number of values.
struct MjcfKind {
  int type;
  FieldSensorKind kind;
  double unit;
  std::size_t numbers;
};
constexpr std::array mjcfKinds{
    MjcfKind{mjSENS_RANGEFINDER, FieldSensorKind::whisker, 1000, 1},
    MjcfKind{mjSENS_TOUCH, FieldSensorKind::touch, 1, 1},
    MjcfKind{mjSENS_ACCELEROMETER, FieldSensorKind::acceleration, 1000, 3},
    MjcfKind{mjSENS_GYRO, FieldSensorKind::turning, toDegrees(1), 3},
    MjcfKind{mjSENS_VELOCIMETER, FieldSensorKind::speed, 1000, 3},
    MjcfKind{mjSENS_MAGNETOMETER, FieldSensorKind::compass, toDegrees(1), 1}};

/// The kinds that MJCF does not know, and the numbers that their `numeric` has.
struct UserKind {
  FieldSensorKind kind;
  std::size_t numbers;
};
constexpr std::array userKinds{
    UserKind{FieldSensorKind::ultrasonic, 2}, UserKind{FieldSensorKind::whiskerField, 5},
    UserKind{FieldSensorKind::receptor, 1}, UserKind{FieldSensorKind::facette, 4}};

std::string sensorName(const mjModel& model, int id) {
  const char* name = mj_id2name(&model, mjOBJ_SENSOR, id);
  return name ? name : "sensor" + std::to_string(id);
}

/// Sets the kind of a `user` sensor by the `numeric` of its name; false if there is none.
bool setUserKind(const mjModel& model, FieldSensorModel& sensor) {
  for (const auto& [kind, numbers] : userKinds) {
    const auto data = customNumbers(model, std::string{enumName(kind)} + "/" + sensor.name);
    if (data.size() != numbers) continue;
    sensor.kind = kind;
    if (numbers >= 4) {
      sensor.columns = static_cast<int>(std::clamp(data[0], 1., 1000.));
      sensor.rows = static_cast<int>(std::clamp(data[1], 1., 1000.));
      sensor.width = fromDegrees(data[2]);
      sensor.height = fromDegrees(data[3]);
    } else {
      sensor.width = sensor.height = fromDegrees(data[0]);
      if (kind == FieldSensorKind::receptor) sensor.columns = sensor.rows = receptorRays;
    }
    sensor.range = data.back() / 1000;
    return true;
  }
  return false;
}

}  // namespace

std::optional<FieldSensorModel> fieldSensor(const mjModel& model, int id) {
  FieldSensorModel sensor;
  sensor.name = sensorName(model, id);
  sensor.id = id;
  if (model.sensor_objtype[id] == mjOBJ_SITE) sensor.site = model.sensor_objid[id];
  double unit = 1;
  const auto known = std::ranges::find(mjcfKinds, model.sensor_type[id], &MjcfKind::type);
  if (known != mjcfKinds.end()) {
    sensor.kind = known->kind;
    unit = known->unit;
    sensor.numbers = known->numbers;
    if (sensor.kind == FieldSensorKind::whisker)
      sensor.range = model.sensor_cutoff[id] > 0 ? model.sensor_cutoff[id] : farthest;
  } else if (model.sensor_type[id] == mjSENS_USER) {
    if (model.sensor_objtype[id] != mjOBJ_SITE || !setUserKind(model, sensor)) return std::nullopt;
    const bool distance =
        sensor.kind == FieldSensorKind::ultrasonic || sensor.kind == FieldSensorKind::whiskerField;
    if (distance)
      unit = 1000;
    else
      sensor.numbers = 3;
    if (sensor.kind == FieldSensorKind::whiskerField || sensor.kind == FieldSensorKind::facette)
      sensor.numbers *= static_cast<std::size_t>(sensor.columns * sensor.rows);
  } else {
    if (model.sensor_needstage[id] != mjSTAGE_POS) return std::nullopt;
    sensor.numbers = static_cast<std::size_t>(model.sensor_dim[id]);
  }
  sensor.noise = unit * model.sensor_noise[id];
  return sensor;
}

std::string_view describe(FieldSensorKind kind) {
  static constexpr EnumArray<FieldSensorKind, std::string_view> descriptions{
      {"mm to what is ahead", "mm to what is ahead, row by row from the top left",
       "mm to the nearest surface in its cone", "y, cb and cr of what is ahead, in the mean",
       "y, cb and cr of each pixel, row by row from the top left",
       "1 if something but the floor touches it", "mm/s^2 in its own axes, with gravity",
       "deg/s about its own axes", "mm/s in its own axes",
       "deg: where its x axis points, 0 to the sky-blue goal", "as MuJoCo measures it: m, rad"}};
  return descriptions[kind];
}

Result<void> checkFieldSensors(const mjModel& model, const std::string& file) {
  for (int id = 0; id < model.nsensor; ++id) {
    if (fieldSensor(model, id)) continue;
    return Error{
        .file = file,
        .field = sensorName(model, id),
        .what = model.sensor_type[id] == mjSENS_USER
                    ? "expected a site, and a <numeric> with the name of a kind and this one's: "
                      "ultrasonic/, whiskerField/, receptor/ or facette/"
                    : "is of a kind that the simulator does not know"};
  }
  return {};
}

}  // namespace gt
