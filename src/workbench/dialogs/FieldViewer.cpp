#include <algorithm>
#include <cmath>

#include "simulation/world/Oracle.h"
#include "views/ViewText.h"
#include "workbench/DrawingMenu.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

/// Report J.3.2, I.3.3.2: the field from above, with drawings on it.
class FieldViewer : public ViewDialog {
 public:
  explicit FieldViewer(SessionThread& session) : ViewDialog{session, nullptr} {
    setKeys({"SelfLocator/pose", "SelfLocator/samples", "BallLocator/ball", "TeamBallLocator/ball",
             "PlayersLocator/players"});
    compose();
    sheet().placeText = [this](const QPointF& place) {
      const Vector2d at = onField(place);
      return QString{"%1, %2 mm"}.arg(at.x(), 0, 'f', 0).arg(at.y(), 0, 'f', 0);
    };
  }

  QJsonObject settings() const override {
    QJsonObject settings = ViewDialog::settings();
    settings["parts"] = arrayOf(parts_);
    settings["drawings"] = arrayOf(keys());
    return settings;
  }
  void restore(const QJsonObject& settings) override {
    ViewDialog::restore(settings);
    if (settings["parts"].isArray()) parts_ = namesOf(settings["parts"]);
    if (settings["drawings"].isArray()) setKeys(namesOf(settings["drawings"]));
    compose();
  }

 protected:
  void addActions(QMenu& menu, const QPointF& place) override {
    QMenu* put = menu.addMenu("Put here");
    const auto add = [&](const std::string& what) {
      put->addAction(QString::fromStdString(what), this,
                     [this, what, at = onField(place)] { putThere(what, at); });
    };
    add("ball");
    for (const RobotInfo& known : session().status().robots)
      if (known.inScene) add(known.name);
    menu.addSeparator();
    constexpr std::pair<const char*, const char*> names[] = {{"fieldPolygons", "Areas"},
                                                             {"fieldLines", "Lines"},
                                                             {"flags", "Flags"},
                                                             {"truth", "Truth"}};
    for (const auto& [part, text] : names) {
      QAction* action = menu.addAction(text);
      action->setCheckable(true);
      action->setChecked(std::ranges::find(parts_, part) != parts_.end());
      QObject::connect(action, &QAction::toggled, this, [this, name = std::string{part}](bool on) {
        std::erase(parts_, name);
        if (on) parts_.push_back(name);
        compose();
      });
    }
    addDrawingMenu(menu, knownKeys(), keys(), [this](const std::string& key, bool on) {
      showKey(key, on);
      compose();
    });
  }

 private:
  /// A place on the field, in mm, as the robot's team sees it.
  Vector2d onField(const QPointF& place) const {
    const Sheet* const shown = sheet().sheet();
    if (!shown) return Vector2d::Zero();
    return Vector2d{place.x() - shown->width() / 2.0, shown->height() / 2.0 - place.y()} /
           fieldViewScale;
  }

  void putThere(const std::string& what, const Vector2d& at) {
    session().ask(
        this,
        [robot = robot(), at](Console& console) {
          ViewSubject subject = console.viewSubject();
          ConsoleRobot* const chosen = console.session().find(robot);
          ObservedRobot* const seenBy = chosen                   ? &chosen->observed()
                                        : subject.robots.empty() ? nullptr
                                                                 : subject.robots.front();
          return toTeam(seenBy ? teamOf(*seenBy) : TeamColor::red, at);
        },
        [this, what](const Vector2d& there) {
          session().execute("place " + what + " " + std::to_string(std::lround(there.x())) + " " +
                            std::to_string(std::lround(there.y())));
        });
  }

  void compose() {
    // In the view's order, which is from below to above.
    std::vector<std::string> elements;
    for (const std::string& part : fieldViewElements)
      if (std::ranges::find(parts_, part) != parts_.end()) elements.push_back(part);
    elements.insert(elements.end(), keys().begin(), keys().end());
    setView(makeFieldView("field", "", elements));
  }

  std::vector<std::string> parts_{"fieldPolygons", "fieldLines", "flags", "truth"};
};

const RegisterDialog<FieldViewer> registeredFieldViewer{
    {.id = "field",
     .title = "Field",
     .group = "Viewers",
     .help = "The field from above with drawings on it, as the robot's team sees it",
     .report = "J.3.2",
     .place = DialogPlace::center,
     .several = true,
     .atFirst = true}};

}  // namespace
}  // namespace gt
