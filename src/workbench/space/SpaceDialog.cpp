#include "workbench/space/SpaceDialog.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "workbench/RobotMenu.h"

namespace gt {
namespace {

/// A scene that is drawn slowly rests this many times as long, so that the window stays responsive.
constexpr double spaceRestFactor = 3;

}  // namespace

SpaceDialog::SpaceDialog(SessionThread& session) : Dialog{session}, view_{new GlView} {
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  view_->setObjectName("view");
  view_->addActions = [this](QMenu& menu, const QPointF& at) {
    addActions(menu, at);
    menu.addSeparator();
    addRobotMenu(menu, this->session(), robot_,
                 [this](const std::string& chosen) { setRobot(chosen); });
  };
}

QJsonObject SpaceDialog::settings() const {
  return {{"robot", QString::fromStdString(robot_)}, {"camera", view_->camera().settings()}};
}

void SpaceDialog::restore(const QJsonObject& settings) {
  setRobot(settings["robot"].toString().toStdString());
  view_->camera().restore(settings["camera"].toObject());
}

void SpaceDialog::setRobot(const std::string& robot) {
  robot_ = robot;
  drawAgain();
}

void SpaceDialog::refresh() {
  const std::uint64_t version = session().version();
  if (asked_ || version == shown_) return;
  if (answered_.isValid() &&
      static_cast<double>(answered_.elapsed()) < spaceRestFactor * view_->drawTime())
    return;
  asked_ = true;
  shown_ = version;
  struct Answer {
    std::shared_ptr<GlScene> scene;
    std::string text;
  };
  session().ask(
      this,
      [draw = drawing(), robot = robot_, prepared = prepared_,
       beginnings = session().status().beginnings](Console& console) -> Answer {
        const mjModel& model = console.session().simulation().world().model();
        if (!prepared->model || prepared->beginnings != beginnings ||
            prepared->model->ngeom != model.ngeom)
          *prepared = {beginnings, modelToDraw(model), nullptr};
        auto scene = std::exchange(prepared->spare, nullptr);
        if (!scene) scene = std::make_shared<GlScene>(prepared->model);
        ConsoleRobot* shown = console.session().find(robot);
        if (robot.empty())
          if (const auto selected = console.selected(); !selected.empty()) shown = selected.front();
        std::string text = draw({console, shown, *scene});
        return {std::move(scene), std::move(text)};
      },
      [this](Answer& answer) {
        asked_ = false;
        answered_.start();
        // The scene that was shown so far is drawn into next.
        const auto before = view_->scene();
        view_->show(std::move(answer.scene));
        view_->showText(QString::fromStdString(answer.text));
        if (before && before->model() == view_->scene()->model()) prepared_->spare = before;
      });
}

NoOpenGl::NoOpenGl(SessionThread& session) : Dialog{session} {
  auto* text = new QLabel{"This display has no OpenGL."};
  text->setAlignment(Qt::AlignCenter);
  (new QVBoxLayout{this})->addWidget(text);
}

}  // namespace gt
