#include "workbench/ViewDialog.h"

namespace gt {
namespace {

/// Report I.3.2: a robot from near, with its LEDs. Dragging goes round it.
class RobotViewer : public ViewDialog {
 public:
  explicit RobotViewer(SessionThread& session) : ViewDialog{session, builtInView("robot")} {
    sheet().dragged = [this](const QPointF& by) {
      direction_ -= by.x() * 0.6;
      setNumbers({direction_});
    };
  }

  QJsonObject settings() const override {
    QJsonObject settings = ViewDialog::settings();
    settings["direction"] = direction_;
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    ViewDialog::restore(settings);
    direction_ = settings["direction"].toDouble(direction_);
    setNumbers({direction_});
  }

 private:
  double direction_ = 35;  // degrees
};

const RegisterDialog<RobotViewer> registered{
    {.id = "robot",
     .title = "Robot",
     .group = "Simulator",
     .help = "The robot from near, with its LEDs; drag to go round it",
     .report = "I.3.2",
     .place = DialogPlace::right,
     .several = true}};

}  // namespace
}  // namespace gt
