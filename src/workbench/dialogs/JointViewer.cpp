#include <QMenu>
#include <QVBoxLayout>
#include <array>
#include <deque>
#include <map>
#include <mutex>

#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/SensorData.h"
#include "workbench/Dialog.h"
#include "workbench/PlotColors.h"
#include "workbench/RobotMenu.h"

namespace gt {
namespace {

constexpr double shownSeconds = 10;
constexpr std::size_t mostFrames = 5000;

/// Joints that are shown or hidden together.
struct Group {
  const char* name;
  Joint first;
  int count;
};
constexpr Group groups[] = {{"head", Joint::headTilt, 3}, {"mouth", Joint::mouth, 1},
                            {"tail", Joint::tailPan, 2},  {"legFR", Joint::legFR1, 3},
                            {"legFL", Joint::legFL1, 3},  {"legHR", Joint::legHR1, 3},
                            {"legHL", Joint::legHL1, 3},  {"ears", Joint::earL, 2}};

/// The joints of a robot at a time: what its sensors measure, and what is commanded.
struct JointFrame {
  double time = 0;  ///< s
  JointAngles sensed{}, commanded{};
};

/// Takes a frame after each step, on the session's thread.
class JointRecorder {
 public:
  explicit JointRecorder(std::string robot) : robot_{std::move(robot)} {}

  void take(Console& console) {
    ConsoleRobot* robot = console.session().find(robot_);
    if (robot_.empty())
      if (const auto selected = console.selected(); !selected.empty()) robot = selected.front();
    if (!robot) return;
    const auto sensors = robot->observed().value<SensorDataBuffer>();
    const auto joints = robot->observed().value<JointData>();
    if (!sensors || !joints) return;
    const std::lock_guard lock{mutex_};
    frames_.push_back({static_cast<double>(console.session().time().ms) / 1000,
                       (*sensors)->newest().joints, (*joints)->angles});
    if (frames_.size() > mostFrames) frames_.pop_front();
  }
  std::deque<JointFrame> takeFrames() {
    const std::lock_guard lock{mutex_};
    return std::exchange(frames_, {});
  }

 private:
  std::string robot_;
  std::mutex mutex_;
  std::deque<JointFrame> frames_;
};

/// Report B.1.2: sensor values of the joints and what the joints are told, over time.
class JointViewer : public Dialog {
 public:
  explicit JointViewer(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    plot_ = new QCustomPlot;
    plot_->setMinimumHeight(80);
    plot_->legend->setVisible(true);
    keepLegendInside(*plot_);
    plot_->yAxis->setLabel("degrees");
    plot_->setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(plot_, &QWidget::customContextMenuRequested, this,
                     [this](const QPoint& at) { showMenu(plot_->mapToGlobal(at)); });
    layout->addWidget(plot_);
    addCurves();
    setPlotColors(*plot_, palette());
    record();
  }

  QJsonObject settings() const override {
    QJsonObject settings{{"robot", QString::fromStdString(robot_)}};
    for (const auto& [name, curves] : curves_) settings[name] = curves.front()->visible();
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    for (const auto& [name, curves] : curves_)
      show(name, settings[name].toBool(curves.front()->visible()));
    setRobot(settings["robot"].toString().toStdString());
  }

  void refresh() override {
    const auto frames = recorder_->takeFrames();
    if (frames.empty()) return;
    if (frames.back().time < newest_ || session().status().beginnings != beginnings_) clear();
    beginnings_ = session().status().beginnings;
    newest_ = frames.back().time;
    for (std::size_t joint = 0; joint < enumCount<Joint>; ++joint) {
      const auto which = static_cast<Joint>(joint);
      for (const JointFrame& frame : frames) {
        sensed_[joint]->addData(frame.time, toDegrees(frame.sensed[which]));
        commanded_[joint]->addData(frame.time, toDegrees(frame.commanded[which]));
      }
      sensed_[joint]->data()->removeBefore(newest_ - shownSeconds);
      commanded_[joint]->data()->removeBefore(newest_ - shownSeconds);
    }
    plot_->xAxis->setRange(newest_ - shownSeconds, newest_);
    plot_->yAxis->rescale(true);
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }

 protected:
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::PaletteChange) setPlotColors(*plot_, palette());
    Dialog::changeEvent(event);
  }

 private:
  /// A curve for each joint's sensor and each joint's command; the front legs' sensors at first.
  void addCurves() {
    for (const Group& group : groups)
      for (int i = 0; i < group.count; ++i) {
        const auto joint = static_cast<std::size_t>(group.first) + static_cast<std::size_t>(i);
        const auto add = [&](const char* kind, Qt::PenStyle style) {
          QCPGraph* graph = plot_->addGraph();
          const QString name = QString::fromStdString(std::string{enumNames<Joint>[joint]});
          graph->setName(QString{"%1 %2"}.arg(kind, name));
          graph->setPen(
              QPen{QColor::fromHsv(static_cast<int>(joint * 67 % 360), 200, 190), 1.2, style});
          curves_[QString{"%1 %2"}.arg(kind, group.name)].push_back(graph);
          return graph;
        };
        sensed_[joint] = add("sensors", Qt::SolidLine);
        commanded_[joint] = add("actorics", Qt::DashLine);
      }
    for (const auto& [name, curves] : curves_) show(name, name.endsWith(" legFR"));
  }
  void show(const QString& group, bool on) {
    for (QCPGraph* graph : curves_[group]) {
      graph->setVisible(on);
      if (on)
        graph->addToLegend();
      else
        graph->removeFromLegend();
    }
  }
  void showMenu(const QPoint& at) {
    QMenu menu;
    for (const auto& [name, curves] : curves_) {
      QAction* action = menu.addAction(name);
      action->setCheckable(true);
      action->setChecked(curves.front()->visible());
      QObject::connect(action, &QAction::toggled, this, [this, group = name](bool on) {
        show(group, on);
        plot_->replot();
      });
    }
    menu.addSeparator();
    addRobotMenu(menu, session(), robot_, [this](const std::string& chosen) { setRobot(chosen); });
    menu.exec(at);
  }
  void setRobot(const std::string& robot) {
    if (robot == robot_) return;
    robot_ = robot;
    clear();
    record();
  }
  void clear() {
    for (int i = 0; i < plot_->graphCount(); ++i) plot_->graph(i)->data()->clear();
  }
  /// Records frames as long as this dialog has the recorder.
  void record() {
    recorder_ = std::make_shared<JointRecorder>(robot_);
    const auto handle = std::make_shared<std::shared_ptr<const void>>();
    session().change([recorder = std::weak_ptr{recorder_}, handle](Console& console) {
      *handle = console.session().afterSteps([recorder, &console] {
        if (const auto known = recorder.lock()) known->take(console);
      });
    });
    handle_ = handle;
  }

  QCustomPlot* plot_;
  std::array<QCPGraph*, enumCount<Joint>> sensed_{}, commanded_{};
  std::map<QString, std::vector<QCPGraph*>> curves_;  ///< By groups.
  std::shared_ptr<JointRecorder> recorder_;
  std::shared_ptr<const void> handle_;  ///< Its end ends the recording.
  std::string robot_;                   ///< Empty: the connected one.
  double newest_ = 0;
  std::uint64_t beginnings_ = 0;
};

const RegisterDialog<JointViewer> registeredJointViewer{
    {.id = "joints",
     .title = "Joints",
     .group = "Viewers",
     .help = "Sensor values of the joints and what they are told, over time",
     .report = "B.1.2",
     .place = DialogPlace::bottom,
     .several = true}};

}  // namespace
}  // namespace gt
