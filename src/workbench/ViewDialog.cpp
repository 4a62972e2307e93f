#include "workbench/ViewDialog.h"

#include <QLabel>
#include <QMenu>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "workbench/RobotMenu.h"

namespace gt {
namespace {

/// Interval at which a viewer checks why drawings are missing.
constexpr qint64 hintInterval = 1000;  // ms
/// Shortest time for which a sheet is shown if others wait, and how many of them may wait.
constexpr int leastShown = 15;  // ms
constexpr std::size_t mostWaiting = 5;

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
  layout->setSpacing(0);
  layout->addWidget(sheet_, 1);
  hint_ = new QLabel;
  hint_->setObjectName("hint");
  hint_->setWordWrap(true);
  hint_->setMargin(3);
  hint_->setVisible(false);
  QObject::connect(hint_, &QLabel::linkActivated, this, [this](const QString&) {
    for (const DrawingHint& hint : hints_)
      if (hint.off) this->session().executeFor(hinted_, "dk " + hint.key + " on");
  });
  layout->addWidget(hint_);
  next_.setSingleShot(true);
  next_.setInterval(leastShown);
  QObject::connect(&next_, &QTimer::timeout, this, [this] { showNext(); });
  sheet_->painted = [this] {
    if (!waiting_.empty() && !next_.isActive()) next_.start();
  };
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
  supply_.reset();
  waiting_.clear();
}

void ViewDialog::refresh() {
  if (supply_) return supply_->renew();
  supply_ = session().supply(
      this,
      [&thread = session(), view = view_, numbers = numbers_, robot = robot_, keys = keys_,
       prepared = prepared_](Console& console) -> Answer {
        const std::uint64_t beginnings = thread.status().beginnings;
        ViewSubject subject = console.viewSubject();
        if (!robot.empty()) {
          ConsoleRobot* const chosen = console.session().find(robot);
          if (!chosen) return {.error = "There is no robot " + robot + "."};
          subject.robots = {&chosen->observed()};
        }
        ObservedRobot* const first = subject.robots.empty() ? nullptr : subject.robots.front();
        if (first && (prepared->robot != first || prepared->beginnings != beginnings ||
                      prepared->keys != keys)) {
          // A robot that does not know a key draws nothing for it.
          std::vector<std::shared_ptr<const void>> shown;
          for (const std::string& key : keys) shown.push_back(first->showKey(key));
          *prepared = {first, beginnings, keys, first->debugKeys(), std::move(shown), {}, {}};
        }
        if (!first) prepared->hints.clear();
        if (first && (!prepared->looked.isValid() || prepared->looked.elapsed() > hintInterval)) {
          prepared->hints = drawingHints(*first, keys, prepared->known);
          prepared->looked.start();
        }
        Answer answer{.knownKeys = prepared->known, .hints = prepared->hints};
        if (first) answer.robot = first->name();
        auto sheet = view->show(subject, numbers);
        if (sheet) {
          answer.sheet = std::make_shared<const Sheet>(std::move(*sheet));
        } else {
          answer.error = sheet.error().text();
        }
        return answer;
      },
      [this](Answer& answer) { take(std::move(answer)); });
}

/// Shows an answer once the one before was painted: none of a camera's images is left out because
/// the window was busy for a moment.
void ViewDialog::take(Answer answer) {
  waiting_.push_back(std::move(answer));
  while (waiting_.size() > mostWaiting) waiting_.pop_front();
  if (!next_.isActive() && !sheet_->waitsForPainting()) showNext();
}

void ViewDialog::showNext() {
  if (waiting_.empty()) return;
  const Answer answer = std::move(waiting_.front());
  waiting_.pop_front();
  knownKeys_ = answer.knownKeys;
  showHints(answer);
  if (answer.sheet)
    sheet_->showSheet(answer.sheet);
  else
    sheet_->showText(QString::fromStdString(answer.error));
}

/// Names what does not come, with a link that switches on what is off.
void ViewDialog::showHints(const Answer& answer) {
  hinted_ = answer.robot;
  if (answer.hints == hints_) return;
  hints_ = answer.hints;
  QStringList texts;
  bool off = false;
  for (const DrawingHint& hint : hints_) {
    texts << QString::fromStdString(hint.key + " (" + hint.why + ")").toHtmlEscaped();
    off |= hint.off;
  }
  hint_->setText("Not drawn: " + texts.join(", ") + (off ? ". <a href=\"on\">Switch on</a>" : "."));
  hint_->setVisible(!hints_.empty());
}

}  // namespace gt
