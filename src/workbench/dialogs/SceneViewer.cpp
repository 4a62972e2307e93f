#include <QElapsedTimer>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "simulation/world/Oracle.h"
#include "views/ViewText.h"
#include "workbench/ViewDialog.h"
#include "workbench/space/SpaceDialog.h"

namespace gt {
namespace {

/// The groups of geoms in the models.
struct Part {
  const char* name;
  const char* text;
  std::size_t group;
};
constexpr Part parts[] = {{"lines", "Lines", 1},
                          {"landmarks", "Walls, goals and flags", 2},
                          {"robots", "Robots", 3},
                          {"balls", "Balls", 4}};

/// A thing that is dragged by the mouse.
struct Thing {
  std::string name;  ///< As the console names it.
  bool robot = false;
  bool turns = false;  ///< It was taken between its hind legs.
  Pose2D pose;         ///< When it was taken.
  Vector2d taken;      ///< Where, on the ground.
  double height = 0;   ///< Of that place.
};

/// How fast the mouse moves a thing along the ground.
class MouseSpeed {
 public:
  MouseSpeed() { clock_.start(); }
  void move(const Vector2d& to) {
    const double now = clock_.elapsed();
    while (path_.size() > 1 && path_[1].first < now - shownMs) path_.pop_front();
    path_.emplace_back(now, to);
  }
  /// In mm/s, over the last moment.
  Vector2d value() const {
    if (path_.size() < 2) return Vector2d::Zero();
    const double ms = std::max(clock_.elapsed() - path_.front().first, 1.0);
    const Vector2d speed = (path_.back().second - path_.front().second) * 1000 / ms;
    return speed.norm() > fastest ? Vector2d{speed.normalized() * fastest} : speed;
  }

 private:
  static constexpr double shownMs = 120;
  static constexpr double fastest = 5000;  // mm/s

  QElapsedTimer clock_;
  std::deque<std::pair<double, Vector2d>> path_;  ///< ms, place.
};

/// Report J.4, I.3.1: the scene in space, whose robots and balls are moved by the mouse.
class SceneViewer : public SpaceDialog {
 public:
  explicit SceneViewer(SessionThread& session) : SpaceDialog{session} {
    view().grabbed = [this](const QPointF& at) { return take(at); };
    view().dragged = [this](const QPointF& at) {
      if (const auto line = dragTo(at); line && !this->session().busy())
        this->session().executeQuietly(*line);
    };
    view().dropped = [this](const QPointF& at, Qt::KeyboardModifiers keys) {
      if (const auto line = dragTo(at))
        this->session().execute(*line + (keys & Qt::ShiftModifier ? speedText() : ""));
    };
    view().doubleClicked = [this](const QPointF& at) {
      const auto thing = thingAt(at);
      if (thing && thing->robot) this->session().execute("robot " + thing->name);
    };
  }

  QJsonObject settings() const override {
    QJsonObject settings = SpaceDialog::settings();
    settings["wireFrames"] = look_.style.wireFrames;
    settings["transparent"] = look_.style.transparent;
    settings["contacts"] = look_.style.contacts;
    settings["beliefs"] = look_.beliefs;
    for (const Part& part : parts) settings[part.name] = look_.style.groups[part.group];
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    SpaceDialog::restore(settings);
    look_.style.wireFrames = settings["wireFrames"].toBool(look_.style.wireFrames);
    look_.style.transparent = settings["transparent"].toBool(look_.style.transparent);
    look_.style.contacts = settings["contacts"].toBool(look_.style.contacts);
    look_.beliefs = settings["beliefs"].toBool(look_.beliefs);
    for (const Part& part : parts)
      look_.style.groups[part.group] = settings[part.name].toBool(look_.style.groups[part.group]);
  }

 protected:
  Draw drawing() const override {
    return [look = look_](const Canvas& canvas) -> std::string {
      const World& world = canvas.console.session().simulation().world();
      canvas.scene.show(world, look.style);
      if (look.beliefs)
        for (ConsoleRobot* robot : canvas.console.selected())
          addBeliefs(world, *robot, canvas.scene);
      return {};
    };
  }

  void addActions(QMenu& menu, const QPointF&) override {
    const auto add = [&](const char* text, bool on, auto change) {
      QAction* action = menu.addAction(text);
      action->setCheckable(true);
      action->setChecked(on);
      QObject::connect(action, &QAction::toggled, this, [this, change](bool checked) {
        change(checked);
        drawAgain();
      });
    };
    add("Beliefs of the connected robots", look_.beliefs, [this](bool on) { look_.beliefs = on; });
    add("Wire frames", look_.style.wireFrames, [this](bool on) { look_.style.wireFrames = on; });
    add("Transparent", look_.style.transparent, [this](bool on) { look_.style.transparent = on; });
    add("Contacts and forces", look_.style.contacts,
        [this](bool on) { look_.style.contacts = on; });
    QMenu* shown = menu.addMenu("Parts");
    for (const Part& part : parts) {
      QAction* action = shown->addAction(part.text);
      action->setCheckable(true);
      action->setChecked(look_.style.groups[part.group]);
      QObject::connect(action, &QAction::toggled, this, [this, group = part.group](bool on) {
        look_.style.groups[group] = on;
        drawAgain();
      });
    }
    menu.addSeparator();
    for (const auto& [text, azimuth, elevation] : {std::tuple{"From the side", -90.0, 33.0},
                                                   {"From behind the blue goal", 0.0, 25.0},
                                                   {"From above", -90.0, 89.0}})
      menu.addAction(text, this, [this, a = azimuth, e = elevation] {
        OrbitCamera& camera = view().camera();
        camera = {.azimuth = a, .elevation = e};
        view().update();
      });
  }

 private:
  struct Look {
    GlStyle style{.groups = {true, true, true, true, true, false}};
    bool beliefs = false;
  };

  /// A robot where it believes to be, and its ball.
  static void addBeliefs(const World& world, ConsoleRobot& robot, GlScene& scene) {
    const auto pose = robot.observed().value<RobotPose>();
    if (!robot.index() || !pose) return;
    const Pose2D believed = toTeam(teamOf(robot.observed()), (*pose)->pose);
    const RobotParts& shape = world.parts(*robot.index());
    scene.addGhost(shape.firstGeom, shape.lastGeom, world.robot(*robot.index()).pose, believed);
    const auto ball = robot.observed().value<BallModel>();
    if (!ball || (*ball)->lastSeen == never() || world.ballCount() == 0) return;
    const Vector2d at = believed * (*ball)->position;
    const double radius = world.ballRadius(0);
    scene.add(mjGEOM_SPHERE, Vector3d::Constant(radius), {at.x(), at.y(), radius},
              {255, 150, 40, 110});
  }

  /// The robot or ball that is seen at a point of the widget.
  std::optional<Thing> thingAt(const QPointF& point) const {
    const auto picked = view().pick(point);
    if (!picked) return std::nullopt;
    const mjModel& model = *view().scene()->model();
    const int body = model.body_rootid[model.geom_bodyid[picked->geom]];
    const std::string name = nameOf(model, mjOBJ_BODY, body);
    Thing thing;
    thing.name = name.substr(0, name.find('/'));
    thing.taken = picked->point.head<2>();
    thing.height = picked->point.z();
    const auto robots = session().status().robots;
    thing.robot = std::ranges::find(robots, thing.name, &RobotInfo::name) != robots.end();
    if (thing.name == "ball0") thing.name = "ball";
    if (!thing.robot && !thing.name.starts_with("ball")) return std::nullopt;
    return thing;
  }

  bool take(const QPointF& at) {
    speed_ = {};
    thing_ = thingAt(at);
    if (!thing_) return false;
    known_ = false;
    // Where it stands is known a moment later.
    session().ask(
        this,
        [name = thing_->name, robot = thing_->robot](Console& console) -> std::optional<Pose2D> {
          const World& world = console.session().simulation().world();
          if (robot) {
            const ConsoleRobot* const found = console.session().find(name);
            const auto index = found ? found->index() : std::nullopt;
            return index ? std::optional{world.robot(*index).pose} : std::nullopt;
          }
          const std::size_t ball = name == "ball" ? 0 : std::stoul(name.substr(4));
          return Pose2D{0, world.ball(ball).position};
        },
        [this](const std::optional<Pose2D>& pose) {
          if (!thing_ || !pose) return;
          thing_->pose = *pose;
          thing_->turns = thing_->robot && relative(*pose, thing_->taken).x() < 0;
          known_ = true;
        });
    return true;
  }

  /// The command that moves the thing along the ground by as much as the mouse has moved, or turns
  /// the robot about the middle of its forelegs.
  std::optional<std::string> dragTo(const QPointF& at) {
    if (!thing_) return std::nullopt;
    const auto there = view().ray(at).atHeight(thing_->height);
    if (!there) return std::nullopt;
    speed_.move(there->head<2>());
    if (!known_) return std::nullopt;
    const Vector2d by = there->head<2>() - thing_->taken;
    Pose2D pose = thing_->pose;
    if (thing_->turns) {
      const Vector2d forelegs = pose * Vector2d{forelegsAhead, 0};
      const Vector2d before = thing_->taken - forelegs, now = there->head<2>() - forelegs;
      pose.rotation = normalize(pose.rotation + std::atan2(now.y(), now.x()) -
                                std::atan2(before.y(), before.x()));
      pose.translation = forelegs - rotated(Vector2d{forelegsAhead, 0}, pose.rotation);
    } else {
      pose.translation += by;
    }
    std::string line = "place " + thing_->name + " " +
                       std::to_string(std::lround(pose.translation.x())) + " " +
                       std::to_string(std::lround(pose.translation.y()));
    if (thing_->robot) line += " " + std::to_string(std::lround(toDegrees(pose.rotation)));
    return line;
  }
  /// The end of a command that throws a ball as fast as the mouse moves.
  std::string speedText() const {
    if (thing_->robot) return {};
    const Vector2d speed = speed_.value();
    return " " + std::to_string(std::lround(speed.x())) + " " +
           std::to_string(std::lround(speed.y()));
  }

  static constexpr double forelegsAhead = 75;  // mm, of the body's center

  Look look_;
  std::optional<Thing> thing_;
  MouseSpeed speed_;
  bool known_ = false;
};

constexpr double degreesPerPixel = 0.4;
constexpr double nearest = 400, farthest = 12000;  // mm
constexpr double lowest = 3, highest = 89;         // degrees

/// The same without OpenGL: dragging turns it, the wheel goes nearer.
class PaintedSceneViewer : public ViewDialog {
 public:
  explicit PaintedSceneViewer(SessionThread& session) : ViewDialog{session, builtInView("scene")} {
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

const RegisterDialog<SceneViewer> registeredSceneViewer{
    {.id = "scene",
     .title = "Scene",
     .group = "Simulator",
     .help =
         "The simulated scene in space; robots and balls are dragged by the mouse, balls thrown "
         "with Shift",
     .report = "J.4",
     .place = DialogPlace::center,
     .several = true,
     .atFirst = true,
     .make = makeInSpace<SceneViewer, PaintedSceneViewer>}};

}  // namespace
}  // namespace gt
