#include "workbench/ViewDialog.h"

#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "workbench/RobotMenu.h"

namespace gt {
namespace {

/// A view that takes long rests this many times as long, so that it does not hold up the others.
constexpr double restFactor = 3;

}  // namespace

std::shared_ptr<const View> builtInView(std::string_view name) {
  for (const auto& view : builtInViews())
    if (view->name() == name) return view;
  return nullptr;
}

ViewDialog::ViewDialog(SessionThread& session, std::shared_ptr<const View> view)
    : Dialog{session}, sheet_{new SheetWidget}, view_{std::move(view)} {
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(sheet_);
  sheet_->addActions = [this](QMenu& menu, const QPointF& place) {
    addActions(menu, place);
    menu.addSeparator();
    addRobotMenu(menu, this->session(), robot_,
                 [this](const std::string& chosen) { setRobot(chosen); });
  };
}

QJsonObject ViewDialog::settings() const {
  return {{"robot", QString::fromStdString(robot_)}};
}

void ViewDialog::restore(const QJsonObject& settings) {
  setRobot(settings["robot"].toString().toStdString());
}

void ViewDialog::setRobot(const std::string& robot) {
  robot_ = robot;
  askAgain();
}

void ViewDialog::setView(std::shared_ptr<const View> view) {
  view_ = std::move(view);
  askAgain();
}

void ViewDialog::setNumbers(std::vector<double> numbers) {
  numbers_ = std::move(numbers);
  askAgain();
}

void ViewDialog::showKey(const std::string& key, bool on) {
  auto shown = keys_;
  std::erase(shown, key);
  if (on) shown.push_back(key);
  setKeys(std::move(shown));
}

void ViewDialog::setKeys(std::vector<std::string> keys) {
  keys_ = std::move(keys);
  askAgain();
}

void ViewDialog::askAgain() {
  shown_ = 0;
}

void ViewDialog::refresh() {
  const std::uint64_t version = session().version();
  if (asked_ || version == shown_) return;
  if (answered_.isValid() && static_cast<double>(answered_.elapsed()) < rest_) return;
  asked_ = true;
  shown_ = version;
  const std::uint64_t beginnings = session().status().beginnings;
  session().ask(
      this,
      [view = view_, numbers = numbers_, robot = robot_, keys = keys_, prepared = prepared_,
       beginnings](Console& console) -> Answer {
        QElapsedTimer clock;
        clock.start();
        ViewSubject subject = console.viewSubject();
        if (!robot.empty()) {
          ConsoleRobot* const chosen = console.session().find(robot);
          if (!chosen) return {nullptr, "There is no robot " + robot + ".", {}, 0};
          subject.robots = {&chosen->observed()};
        }
        ObservedRobot* const first = subject.robots.empty() ? nullptr : subject.robots.front();
        if (first && (prepared->robot != first || prepared->beginnings != beginnings ||
                      prepared->keys != keys)) {
          *prepared = {first, beginnings, keys, first->debugKeys()};
          // A robot that does not know a key draws nothing for it.
          for (const std::string& key : keys)
            static_cast<void>(first->request(DebugRequest{key, DebugKeyMode::always, 0}));
        }
        auto sheet = view->show(subject, numbers);
        if (!sheet) return {nullptr, sheet.error().text(), prepared->known, 0};
        return {std::make_shared<const Sheet>(std::move(*sheet)),
                {},
                prepared->known,
                static_cast<double>(clock.nsecsElapsed()) / 1e6};
      },
      [this](Answer& answer) {
        asked_ = false;
        answered_.start();
        rest_ = restFactor * answer.ms;
        knownKeys_ = std::move(answer.knownKeys);
        if (answer.sheet)
          sheet_->showSheet(std::move(answer.sheet));
        else
          sheet_->showText(QString::fromStdString(answer.error));
      });
}

}  // namespace gt
