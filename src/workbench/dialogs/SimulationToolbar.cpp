#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/IconButton.h"

namespace gt {
namespace {

struct Speed {
  const char* text;
  double factor;
};
constexpr Speed speeds[] = {{"0.1×", 0.1}, {"0.25×", 0.25}, {"0.5×", 0.5},    {"real time", 1},
                            {"2×", 2},     {"4×", 4},       {"full speed", 0}};

/// Report J.4: starts, stops and resets the simulation, chooses its speed and the connected robot.
class SimulationToolbar : public Dialog {
 public:
  explicit SimulationToolbar(SessionThread& session) : Dialog{session} {
    auto* layout = new QHBoxLayout{this};
    layout->setContentsMargins(2, 0, 2, 0);
    const auto button = [&](auto... what) { return addIconButton(*layout, *this, what...); };
    start_ = button("start", QStyle::SP_MediaPlay, "Lets time pass, or stand (F5)", [this] {
      if (occupied_ && this->session().busy())
        this->session().interrupt();
      else
        this->session().execute(this->session().status().started ? "stop" : "start");
    });
    button("step", QStyle::SP_MediaSkipForward, "A step of 8 ms (F10)",
           [this] { this->session().execute("step"); });
    button("reset", QStyle::SP_MediaSkipBackward,
           "Begins anew with the same scene and seed (Ctrl+F5)",
           [this] { this->session().execute("reset"); });
    speed_ = makeControl<QComboBox>("speed", "How fast simulated time passes at most");
    for (const Speed& speed : speeds) speed_->addItem(speed.text, speed.factor);
    QObject::connect(speed_, &QComboBox::activated, this, [this](int index) {
      const double factor = speed_->itemData(index).toDouble();
      this->session().execute("st on" +
                              (factor > 0 ? " " + QString::number(factor).toStdString() : ""));
    });
    layout->addWidget(speed_);
    robot_ = makeControl<QComboBox>("robot", "The robot that dialogs are connected with");
    robot_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    QObject::connect(robot_, &QComboBox::activated, this, [this](int index) {
      this->session().execute("robot " + robot_->itemData(index).toString().toStdString());
    });
    layout->addWidget(robot_);
  }

  void refresh() override {
    const SessionStatus status = session().status();
    // Most commands end before anybody sees that they run.
    const bool wasBusy = std::exchange(busy_, session().busy());
    occupied_ = wasBusy && busy_;
    const bool runs = status.started || occupied_;
    if (runs != runs_) {
      runs_ = runs;
      start_->showIcon(runs ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay);
    }
    if (!speed_->view()->isVisible())
      for (int i = 0; i < speed_->count(); ++i)
        if (speed_->itemData(i).toDouble() == status.pace) speed_->setCurrentIndex(i);
    showRobots(status);
  }

 private:
  void showRobots(const SessionStatus& status) {
    if (robot_->view()->isVisible()) return;
    QStringList names;
    for (const RobotInfo& robot : status.robots) names << QString::fromStdString(robot.name);
    if (names != names_) {
      names_ = names;
      robot_->clear();
      for (const QString& name : names) robot_->addItem(name, name);
      robot_->addItem("all robots", "all");
    }
    const auto selected = std::ranges::count_if(status.robots, &RobotInfo::selected);
    int index = static_cast<int>(names.size());
    if (selected == 1)
      for (std::size_t i = 0; i < status.robots.size(); ++i)
        if (status.robots[i].selected) index = static_cast<int>(i);
    robot_->setCurrentIndex(index);
  }

  IconButton* start_;
  QComboBox* speed_;
  QComboBox* robot_;
  QStringList names_;
  bool runs_ = false;      ///< as the button shows it
  bool busy_ = false;      ///< at the last look
  bool occupied_ = false;  ///< by a command, at the last two looks
};

const RegisterDialog<SimulationToolbar> registeredSimulationToolbar{
    {.id = "simulation",
     .title = "Simulation",
     .group = "Toolbars",
     .help = "Starts, stops and resets the simulation; its speed; the connected robot",
     .report = "J.4",
     .place = DialogPlace::toolbar,
     .atFirst = true}};

}  // namespace
}  // namespace gt
