#include <QApplication>
#include <QTimer>
#include <span>
#include <string_view>
#include <utility>

#include "workbench/ViewDialog.h"
#include "workbench/space/SpaceDialog.h"

namespace gt {
namespace {

/// What a click on a part of the body presses.
constexpr std::pair<std::string_view, Switch> switchParts[] = {
    {"back", Switch::back},       {"tricotBack", Switch::back}, {"face", Switch::headFront},
    {"visor", Switch::headFront}, {"skull", Switch::headBack},  {"tricotHead", Switch::headBack},
    {"footFL", Switch::pawFL},    {"footFR", Switch::pawFR},    {"footHL", Switch::pawHL},
    {"footHR", Switch::pawHR},    {"jaw", Switch::chin},        {"muzzle", Switch::chin}};

/// An LED in the head, in mm of the head's axes: on the visor, or on top.
struct LedPlace {
  Led led;
  Vector3d at;
  Color color;
};
constexpr double ledRadius = 3.5, darkLedRadius = 2;  // mm
const LedPlace headLeds[] = {{Led::upperLeft, {42, 11, 27}, colors::red},
                             {Led::middleLeft, {44, 15, 21}, colors::green},
                             {Led::lowerLeft, {43, 11, 15}, colors::red},
                             {Led::upperRight, {42, -11, 27}, colors::red},
                             {Led::middleRight, {44, -15, 21}, colors::green},
                             {Led::lowerRight, {43, -11, 15}, colors::red},
                             {Led::top, {4, 0, 52}, colors::green}};
const LedPlace tailLeds[] = {{Led::tailBlue, {-58, 0, 4}, {90, 130, 255}},
                             {Led::tailRed, {-50, 0, 6}, colors::orange}};

std::string partOf(const mjModel& model, int geom) {
  const std::string name = nameOf(model, mjOBJ_GEOM, geom);
  return name.substr(name.find('/') + 1);
}

/// LEDs that shine are larger than those that do not.
void addLeds(const World& world, const std::string& bodyName, std::span<const LedPlace> leds,
             const LedValue& values, GlScene& scene) {
  const int body = mj_name2id(&world.model(), mjOBJ_BODY, bodyName.c_str());
  if (body < 0) return;
  const Vector3d origin = fromMuJoCo(world.data().xpos + 3 * body);
  const Matrix3d rotation = rotationFromMuJoCo(world.data().xmat + 9 * body);
  for (const LedPlace& place : leds) {
    const bool lit = values.lit[place.led];
    scene.add(mjGEOM_SPHERE, Vector3d::Constant(lit ? ledRadius : darkLedRadius),
              origin + rotation * place.at, lit ? place.color : Color{75, 75, 80});
  }
}

/// Report J.4, I.3.2: the robot alone with its LEDs. A click presses a switch or releases it, a
/// double click throws the robot over or puts it on its feet.
class RobotViewer : public SpaceDialog {
 public:
  explicit RobotViewer(SessionThread& session) : SpaceDialog{session} {
    view().camera() = {.at = {0, 0, 110}, .azimuth = 35, .elevation = 25, .distance = 700};
    view().setLowest(-80);
    // A click counts once it cannot become a double click any more.
    click_.setSingleShot(true);
    click_.setInterval(QApplication::doubleClickInterval());
    QObject::connect(&click_, &QTimer::timeout, this, [this] { press(clickedAt_); });
    view().clicked = [this](const QPointF& at) {
      if (std::exchange(doubleClicked_, false)) return;
      clickedAt_ = at;
      click_.start();
    };
    view().doubleClicked = [this](const QPointF&) {
      click_.stop();
      doubleClicked_ = true;
      throwOver();
    };
  }

 protected:
  Draw drawing() const override {
    return [](const Canvas& canvas) -> std::string {
      Simulation& simulation = canvas.console.session().simulation();
      const World& world = simulation.world();
      if (!canvas.robot || !canvas.robot->index()) {
        canvas.scene.clear();
        return "The connected robot is not in the scene.";
      }
      const std::size_t index = *canvas.robot->index();
      const RobotBody& body = world.robot(index);
      const bool fallen = body.posture != Posture::standing;
      const RobotParts& parts = world.parts(index);
      canvas.scene.show(world, {.groups = {true, true, true, true, true, false}});
      canvas.scene.keep([&](int geom) {
        return geom >= parts.firstGeom && geom < parts.lastGeom &&
               !(fallen && partOf(world.model(), geom).starts_with("tricot"));
      });
      const LedValue& leds = simulation.output(index).leds;
      addLeds(world, canvas.robot->name() + "/head", headLeds, leds, canvas.scene);
      addLeds(world, canvas.robot->name() + "/tail", tailLeds, leds, canvas.scene);
      canvas.scene.move(body.pose, Pose2D{});
      return canvas.robot->name() + (fallen ? " has fallen" : "");
    };
  }

 private:
  void press(const QPointF& at) {
    const auto picked = view().pick(at);
    if (!picked) return;
    const std::string part = partOf(*view().scene()->model(), picked->geom);
    for (const auto& [name, which] : switchParts)
      if (part == name)
        doWithRobot([which = which](Simulation& simulation, ConsoleRobot& robot) {
          const bool on = simulation.sensors(*robot.index()).isPressed(which);
          return "press " + std::string{enumName(which)} + (on ? " off" : " on");
        });
  }
  void throwOver() {
    doWithRobot([](Simulation& simulation, ConsoleRobot& robot) {
      const bool stands = simulation.world().robot(*robot.index()).posture == Posture::standing;
      return (stands ? "throw " : "stand ") + robot.name();
    });
  }
  /// Executes a line for the robot that is shown, which depends on how the robot is.
  template <typename Line>
  void doWithRobot(Line line) {
    session().ask(
        this,
        [line, robot = robot()](Console& console) -> std::pair<std::string, std::string> {
          ConsoleRobot* shown = console.session().find(robot);
          if (const auto all = console.selected(); robot.empty() && !all.empty())
            shown = all.front();
          if (!shown || !shown->index()) return {};
          return {shown->name(), line(console.session().simulation(), *shown)};
        },
        [this](const std::pair<std::string, std::string>& what) {
          if (!what.first.empty()) session().executeFor(what.first, what.second);
        });
  }

  QTimer click_;
  QPointF clickedAt_;
  bool doubleClicked_ = false;
};

/// The same without OpenGL: dragging goes round the robot.
class PaintedRobotViewer : public ViewDialog {
 public:
  explicit PaintedRobotViewer(SessionThread& session) : ViewDialog{session, builtInView("robot")} {
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

const RegisterDialog<RobotViewer> registeredRobotViewer{
    {.id = "robot",
     .title = "Robot",
     .group = "Simulator",
     .help =
         "The robot alone with its LEDs; a click presses a switch, a double click throws it over",
     .report = "J.4",
     .place = DialogPlace::right,
     .several = true,
     .make = makeInSpace<RobotViewer, PaintedRobotViewer>}};

}  // namespace
}  // namespace gt
