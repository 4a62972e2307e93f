#include <algorithm>
#include <cmath>

#include "workbench/DrawingMenu.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

constexpr double nearestRadar = 300, farthestRadar = 10000;  // mm

/// Report J.3.2: what lies around the robot. The wheel changes how far it looks.
class RadarViewer : public ViewDialog {
 public:
  explicit RadarViewer(SessionThread& session) : ViewDialog{session, builtInView("radar")} {
    setKeys({"ImageProcessor/percepts", "BallLocator/ball", "ObstaclesLocator/radar"});
    sheet().wheeled = [this](double steps) { look(range_ * std::pow(1.15, -steps)); };
    sheet().placeText = [this](const QPointF& place) {
      const double half = sheet().sheet()->width() / 2.0, scale = range_ / half;
      return QString{"%1 mm ahead, %2 mm left"}
          .arg((place.x() - half) * scale, 0, 'f', 0)
          .arg((half - place.y()) * scale, 0, 'f', 0);
    };
    look(range_);
  }

  QJsonObject settings() const override {
    QJsonObject settings = ViewDialog::settings();
    settings["range"] = range_;
    settings["drawings"] = arrayOf(keys());
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    ViewDialog::restore(settings);
    if (settings["drawings"].isArray()) setKeys(namesOf(settings["drawings"]));
    look(settings["range"].toDouble(range_));
  }

 protected:
  void addActions(QMenu& menu, const QPointF&) override {
    addDrawingMenu(menu, knownKeys(), keys(),
                   [this](const std::string& key, bool on) { showKey(key, on); });
  }

 private:
  void look(double range) {
    range_ = std::clamp(range, nearestRadar, farthestRadar);
    setNumbers({range_});
  }

  double range_ = 2400;
};

const RegisterDialog<RadarViewer> registeredRadarViewer{
    {.id = "radar",
     .title = "Radar",
     .group = "Viewers",
     .help = "What lies around the robot, which looks to the right",
     .report = "J.3.2",
     .place = DialogPlace::right,
     .several = true}};

}  // namespace
}  // namespace gt
