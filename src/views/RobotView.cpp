#include <cmath>

#include "views/ScenePicture.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr Color dark{40, 40, 44};

/// An LED's place in the panel, in pixels from the panel's corner, and its color when it is lit.
/// Four of the face are red, those in the middle of both sides and on top are green (facts, 1.3).
struct LedPlace {
  Led led;
  Vector2d at;
  Color color;
};
const LedPlace ledPlaces[] = {
    {Led::top, {70, 22}, colors::green},         {Led::upperLeft, {96, 48}, colors::red},
    {Led::middleLeft, {104, 68}, colors::green}, {Led::lowerLeft, {96, 88}, colors::red},
    {Led::upperRight, {44, 48}, colors::red},    {Led::middleRight, {36, 68}, colors::green},
    {Led::lowerRight, {44, 88}, colors::red},    {Led::tailBlue, {58, 150}, {90, 130, 255}},
    {Led::tailRed, {82, 150}, colors::orange}};

/// Paints the face seen from the front, and the tail below, with the LEDs that are lit.
void paintLeds(Sheet& sheet, const Vector2d& corner, const LedValue& leds) {
  Drawing drawing;
  const auto add = [&](ElementType type, std::vector<Vector2d> points, double size, Color color) {
    for (Vector2d& point : points) point += corner;
    drawing.elements.push_back({type, std::move(points), size, color, 2, ""});
  };
  add(ElementType::area,
      {{40, 10}, {100, 10}, {122, 40}, {122, 96}, {96, 122}, {44, 122}, {18, 96}, {18, 40}}, 0,
      dark);
  add(ElementType::area, {{18, 40}, {4, 52}, {4, 96}, {18, 84}}, 0, dark);
  add(ElementType::area, {{122, 40}, {136, 52}, {136, 96}, {122, 84}}, 0, dark);
  add(ElementType::disk, {{70, 104}}, 8, {20, 20, 22});
  add(ElementType::area, {{46, 136}, {94, 136}, {94, 164}, {46, 164}}, 0, dark);
  for (const LedPlace& place : ledPlaces) {
    const bool lit = leds.lit[place.led];
    const Color& c = place.color;
    if (lit) add(ElementType::disk, {place.at}, 11, {c.r, c.g, c.b, 90});
    add(ElementType::disk, {place.at}, 6.5, lit ? c : Color{75, 75, 80});
  }
  sheet.paint(drawing);
}

class RobotView : public View {
 public:
  RobotView()
      : View{"robot",
             "the robot from near, with its LEDs; the direction from which may follow, in degrees: "
             "0 from ahead, 90 from its left. The tricot of one that has fallen is hidden"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const auto index = subject.sceneRobot((*robot)->name());
    if (!index) return index.error();
    if (numbers.size() > 1)
      return Error{.field = name(),
                   .what = "expected no number, or the direction from which in degrees"};
    const World& world = subject.simulation->world();
    const RobotBody& body = world.robot(*index);
    const double from = body.pose.rotation + fromDegrees(numbers.empty() ? 35 : numbers[0]);
    SceneCamera camera;
    camera.width = 640;
    camera.height = 480;
    camera.openingAngle = 32;
    camera.at = {body.pose.translation.x(), body.pose.translation.y(), 0.8 * body.height};
    camera.from = camera.at + Vector3d{800 * std::cos(from), 800 * std::sin(from), 400};
    const std::string tricot = (*robot)->name() + "/tricot";
    const bool fallen = body.posture != Posture::standing;
    Sheet sheet = pictureSheet(scenePicture(world, camera, fallen ? tricot : ""), 1);
    sheet.text({12, 24}, (*robot)->name() + (fallen ? " has fallen" : ""), colors::white, 16);
    paintLeds(sheet, {10, 36}, subject.simulation->output(*index).leds);
    return sheet;
  }
};

}  // namespace

std::unique_ptr<View> makeRobotView() {
  return std::make_unique<RobotView>();
}

}  // namespace gt
