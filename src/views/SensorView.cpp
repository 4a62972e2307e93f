#include <array>
#include <cmath>

#include "representations/infrastructure/SensorData.h"
#include "views/ViewText.h"
#include "views/Views.h"

namespace gt {
namespace {

class SensorView : public View {
 public:
  SensorView() : View{"sensors", "joints, acceleration, distance and switches"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const auto buffer = (*robot)->value<SensorDataBuffer>();
    if (!buffer) return buffer.error();
    const SensorData& data = (*buffer)->newest();
    Sheet sheet{640, 470};
    TextLines left{sheet, 16};
    left.add({{0, (*robot)->name() + " at " + clockText(data.time)}});
    left.heading("Joints, degrees");
    paintJoints(sheet, left, data);
    TextLines right{sheet, 400};
    right.heading("");
    right.heading("Acceleration, m/s\u00B2");
    constexpr std::array axes{"ahead", "left", "up"};
    for (std::size_t i = 0; i < axes.size(); ++i)
      right.add(
          {{0, axes[i]}, {90, decimal(data.acceleration[static_cast<Eigen::Index>(i)] / 1000, 2)}});
    right.heading("Distance, mm");
    right.add({{0, "psd"}, {90, decimal(data.psd, 0)}});
    right.heading("Switches");
    for (std::size_t i = 0; i < enumCount<Switch>; ++i) {
      const bool pressed = data.switches.values[i];
      right.add({{0, std::string{enumNames<Switch>[i]}}, {90, pressed ? "pressed" : "-"}},
                pressed ? colors::red : faintText);
    }
    return sheet;
  }

 private:
  /// A bar to the right or left for each joint, a pixel a degree.
  static void paintJoints(Sheet& sheet, TextLines& lines, const SensorData& data) {
    constexpr double zero = 240, above = 11, height = 10;
    for (std::size_t i = 0; i < enumCount<Joint>; ++i) {
      const double degrees = toDegrees(data.joints.values[i]);
      lines.add({{0, std::string{enumNames<Joint>[i]}}, {90, decimal(degrees)}});
      sheet.box({zero + std::min(0.0, degrees), lines.y() - above}, {std::abs(degrees), height},
                barColor);
    }
  }
};

}  // namespace

std::unique_ptr<View> makeSensorView() {
  return std::make_unique<SensorView>();
}

}  // namespace gt
