#include "simulation/scene/ScenePeople.h"

#include <array>
#include <cstdio>
#include <string>
#include <utility>

#include "base/Geometry.h"
#include "simulation/scene/Xml.h"

namespace gt {
namespace {

struct Part {
  const char *name, *type, *rgba;
  Vector3d at, size;  ///< Meters.
};

void add(xmlNode* parent, const std::string& person, const Part& part, bool touchable) {
  const auto text = [](const Vector3d& v) {
    char numbers[96];
    std::snprintf(numbers, sizeof numbers, "%.4f %.4f %.4f", v.x(), v.y(), v.z());
    return std::string{numbers};
  };
  xmlNode* geom = xmlNewChild(parent, nullptr, BAD_CAST "geom", nullptr);
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, std::string>>{
           {"name", person + "/" + part.name},
           {"type", part.type},
           {"pos", text(part.at)},
           {"size", text(part.size)},
           {"rgba", part.rgba},
           {"group", touchable ? "2" : "0"},
           {"contype", touchable ? "1" : "0"},
           {"conaffinity", "0"}})
    setAttribute(geom, name, value);
}

}  // namespace

void addAudience(xmlNode* worldbody, int count, Random random) {
  constexpr std::array shirts{"0.98 0.40 0.05 1", "0.95 0.35 0.62 1", "0.93 0.82 0.06 1",
                              "0.20 0.62 0.92 1", "0.75 0.05 0.10 1", "0.08 0.12 0.50 1",
                              "0.05 0.50 0.22 1", "0.90 0.90 0.90 1"};
  for (int i = 0; i < count; ++i) {
    // Somewhere on a rectangle around the outer wall, half of them kneel or are children.
    const double halfX = random.uniform(3.6, 5), halfY = random.uniform(2.7, 4);
    const double along = random.symmetric();
    const double side = random.chance(0.5) ? 1 : -1;
    const Vector2d p = random.chance(halfX / (halfX + halfY))
                           ? Vector2d{halfX * along, side * halfY}
                           : Vector2d{side * halfX, halfY * along};
    const double shirt = random.chance(0.5) ? random.uniform(0.5, 0.8) : random.uniform(1, 1.3);
    const std::string person = "audience" + std::to_string(i);
    const char* color = shirts[static_cast<std::size_t>(i) % shirts.size()];
    const double legs = (shirt - 0.25) / 2;
    add(worldbody, person,
        {"legs", "box", "0.10 0.10 0.14 1", {p.x(), p.y(), legs}, {0.14, 0.12, legs}}, false);
    add(worldbody, person, {"shirt", "ellipsoid", color, {p.x(), p.y(), shirt}, {0.22, 0.2, 0.34}},
        false);
    add(worldbody, person,
        {"head", "ellipsoid", "0.80 0.58 0.46 1", {p.x(), p.y(), shirt + 0.45}, {0.09, 0.09, 0.12}},
        false);
  }
}

void addReferees(xmlNode* worldbody, int count) {
  for (int i = 0; i < count; ++i) {
    // On both sides in turn, spread over the length of the field.
    const double side = i % 2 == 0 ? 1 : -1;
    const double x = side * 3.2 * ((i / 2 + 1.0) / ((count + 1) / 2 + 1.0) - 0.5), y = 1.2 * side;
    const std::string person = "referee" + std::to_string(i);
    for (const bool left : {true, false})
      add(worldbody, person,
          {left ? "left" : "right",
           "cylinder",
           "0.08 0.08 0.09 1",
           {x + (left ? 0.11 : -0.11), y, 0.45},
           {0.06, 0.45, 0}},
          true);
  }
}

}  // namespace gt
