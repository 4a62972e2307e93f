#include <algorithm>
#include <cmath>
#include <numbers>

#include "workbench/ViewDialog.h"

namespace gt {
namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double nearest = 400, farthest = 12000;  // mm
constexpr double lowest = 3, highest = 89;         // degrees

/// Report J.4, I.3.1: the scene in space. Dragging turns it, the wheel goes nearer.
class SceneViewer : public ViewDialog {
 public:
  explicit SceneViewer(SessionThread& session) : ViewDialog{session, builtInView("scene")} {
    sheet().dragged = [this](const QPointF& by) {
      azimuth_ -= by.x() * degreesPerPixel;
      elevation_ = std::clamp(elevation_ + by.y() * degreesPerPixel, lowest, highest);
      look();
    };
    sheet().wheeled = [this](double steps) {
      distance_ = std::clamp(distance_ * std::pow(1.15, -steps), nearest, farthest);
      look();
    };
    look();
  }

  QJsonObject settings() const override {
    QJsonObject settings = ViewDialog::settings();
    settings["azimuth"] = azimuth_;
    settings["elevation"] = elevation_;
    settings["distance"] = distance_;
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    ViewDialog::restore(settings);
    azimuth_ = settings["azimuth"].toDouble(azimuth_);
    elevation_ = std::clamp(settings["elevation"].toDouble(elevation_), lowest, highest);
    distance_ = std::clamp(settings["distance"].toDouble(distance_), nearest, farthest);
    look();
  }

 private:
  void look() {
    constexpr double radians = std::numbers::pi / 180;
    const double a = azimuth_ * radians, e = elevation_ * radians;
    setNumbers({distance_ * std::cos(e) * std::cos(a), distance_ * std::cos(e) * std::sin(a),
                distance_ * std::sin(e), 0, 0, 0});
  }

  double azimuth_ = -90, elevation_ = 33, distance_ = 4200;
};

const RegisterDialog<SceneViewer> registered{
    {.id = "scene",
     .title = "Scene",
     .group = "Simulator",
     .help = "The simulated scene in space; drag to turn it, the wheel goes nearer",
     .report = "J.4",
     .place = DialogPlace::center,
     .several = true,
     .atFirst = true}};

}  // namespace
}  // namespace gt
