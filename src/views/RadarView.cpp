#include "representations/modeling/BallModel.h"
#include "views/ViewText.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr int imageSize = 480;  // pixels
constexpr Color ground{20, 40, 25}, ring{70, 120, 80};

class RadarView : public View {
 public:
  RadarView()
      : View{"radar",
             "what lies around the robot, which looks to the right; how far in mm may "
             "follow"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    if (numbers.size() > 1 || (!numbers.empty() && !(numbers[0] >= 100 && numbers[0] <= 10000)))
      return Error{.field = name(),
                   .what = "expected no number, or how far it looks: 100 to 10000 mm"};
    const double range = numbers.empty() ? 2400 : numbers[0];
    Sheet sheet{imageSize, imageSize, ground};
    const Placement placement{{imageSize / 2.0, imageSize / 2.0}, imageSize / 2.0 / range, true};
    Drawing drawing;
    for (int i = 1; i <= 3; ++i)
      drawing.elements.push_back({ElementType::circle, {{0, 0}}, i * range / 3, ring, 1, ""});
    drawing.elements.push_back({ElementType::line, {{0, 0}, {range, 0}}, 0, ring, 1, ""});
    const Vector2d half{range / 14, range / 28};
    drawing.elements.push_back({ElementType::area,
                                {{-half.x(), -half.y()},
                                 {half.x(), -half.y()},
                                 {half.x(), half.y()},
                                 {-half.x(), half.y()}},
                                0,
                                teamOf(**robot) == TeamColor::red ? colors::red : colors::blue,
                                1,
                                ""});
    if (const auto ball = (*robot)->value<BallModel>())
      drawing.elements.push_back({ElementType::disk,
                                  {(*ball)->position},
                                  subject.field.ballRadius,
                                  colors::orange,
                                  1,
                                  ""});
    sheet.paint(drawing, placement);
    for (const auto& [key, around] : (*robot)->drawings())
      if (around.space == DrawingSpace::robot) sheet.paint(around, placement);
    sheet.text({8, 16}, (*robot)->name() + " looks to the right", colors::white);
    return sheet;
  }
};

}  // namespace

std::unique_ptr<View> makeRadarView() {
  return std::make_unique<RadarView>();
}

}  // namespace gt
