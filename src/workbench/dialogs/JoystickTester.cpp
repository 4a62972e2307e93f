#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

#include "representations/motion/MotionInfo.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int buttonCount = 8;
constexpr int sliderEnd = 100;

std::string decimal(double value) {
  return QString::number(value, 'f', 2).toStdString();
}

/// A stick that is moved by the mouse, and springs back when the mouse lets go.
class StickPad : public QWidget {
 public:
  StickPad() {
    setObjectName("stick");
    setMinimumSize(120, 120);
    setToolTip("The stick: to the right and back are positive");
  }
  std::function<void(const QPointF&)> moved;
  /// From -1 to 1, to the right and back.
  void showAt(const QPointF& at) {
    at_ = at;
    update();
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter{this};
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(palette().color(QPalette::WindowText));
    const QPointF center = rect().center();
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    const QPointF stick = center + QPointF{at_.x() * width() / 2, at_.y() * height() / 2};
    painter.drawLine(center, stick);
    painter.setBrush(palette().highlight());
    painter.drawEllipse(stick, 6, 6);
  }
  void mousePressEvent(QMouseEvent* event) override { move(event->position()); }
  void mouseMoveEvent(QMouseEvent* event) override { move(event->position()); }
  void mouseReleaseEvent(QMouseEvent*) override {
    showAt({0, 0});
    moved(at_);
  }

 private:
  void move(const QPointF& place) {
    showAt({std::clamp(2 * place.x() / width() - 1, -1.0, 1.0),
            std::clamp(2 * place.y() / height() - 1, -1.0, 1.0)});
    moved(at_);
  }

  QPointF at_;
};

/// What was asked of the robot last, and what it does.
struct Asked {
  MotionRequest sent, active, executed;
  bool known = false, movesHead = false;
};

bool same(const MotionRequest& a, const MotionRequest& b) {
  if (a.type != b.type || a.specialAction != b.specialAction) return false;
  if (a.type != MotionType::walk) return true;
  return a.walkType == b.walkType && a.walk.translation.isApprox(b.walk.translation) &&
         std::abs(a.walk.rotation - b.walk.rotation) < 1e-6;
}

QString textOf(const MotionRequest& request) {
  if (request.type == MotionType::specialAction)
    return QString::fromStdString(request.specialAction);
  if (request.type != MotionType::walk)
    return QString::fromStdString(std::string{enumName(request.type)});
  return QString{"walk %1: %2 mm/s ahead, %3 mm/s left, %4°/s"}
      .arg(QString::fromStdString(std::string{enumName(request.walkType)}))
      .arg(request.walk.translation.x(), 0, 'f', 0)
      .arg(request.walk.translation.y(), 0, 'f', 0)
      .arg(toDegrees(request.walk.rotation), 0, 'f', 0);
}

/// Report J.5.5: moves the robot by a joystick, or by the stick, levers and buttons shown here.
class JoystickTester : public Dialog {
 public:
  explicit JoystickTester(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    use_ = makeControl<QCheckBox>("use", "Reads this machine's joystick while time passes",
                                  "Use joystick");
    QObject::connect(use_, &QCheckBox::clicked, this, [this](bool on) {
      // Without a joystick it is refused.
      this->session().execute(on ? "joystick on" : "joystick off", this,
                              [this](const Result<void>& done) {
                                if (!done) use_->setChecked(false);
                              });
    });
    row->addWidget(use_);
    scheme_ = makeControl<QComboBox>("scheme", "What the parts of the joystick do");
    scheme_->addItems({"commands", "stickSpeed", "acceleratorSpeed"});
    QObject::connect(scheme_, &QComboBox::activated, this, [this] {
      this->session().execute("joystick scheme " + scheme_->currentText().toStdString());
    });
    row->addWidget(scheme_);
    auto* parts = new QHBoxLayout;
    layout->addLayout(parts);
    stick_ = new StickPad;
    stick_->moved = [this](const QPointF& at) {
      move("x " + decimal(at.x()) + " y " + decimal(at.y()));
    };
    parts->addWidget(stick_, 1);
    addLever(*parts, "z", "Turns the stick");
    addLever(*parts, "accelerator", "The accelerator lever");
    addButtons(*layout);
    motion_ = makeControl<QLabel>(
        "motion",
        "What is asked of the robot. Red: not yet executed; gray: something else is active");
    motion_->setWordWrap(true);
    layout->addWidget(motion_);
    layout->addStretch();
  }

  QJsonObject settings() const override { return {{"scheme", scheme_->currentText()}}; }
  void restore(const QJsonObject& settings) override {
    scheme_->setCurrentText(settings["scheme"].toString());
  }

  void refresh() override {
    if (asked_) return;
    asked_ = true;
    session().ask(
        this,
        [](Console& console) -> Asked {
          Asked asked;
          const auto robot = console.firstRobot();
          if (!robot) return asked;
          asked.sent = (*robot)->motion;
          const auto active = (*robot)->observed().value<MotionRequest>();
          const auto info = (*robot)->observed().value<MotionInfo>();
          asked.known = active && info;
          if (active) asked.active = **active;
          if (info) asked.executed = (*info)->executed;
          if (const auto& scheme = console.joystickScheme()) asked.movesHead = scheme->movesHead();
          return asked;
        },
        [this](const Asked& asked) { show(asked); });
  }

 private:
  void addLever(QBoxLayout& layout, const char* axis, const char* help) {
    auto* lever = makeControl<QSlider>(axis, help, Qt::Vertical);
    lever->setRange(-sliderEnd, sliderEnd);
    QObject::connect(lever, &QSlider::valueChanged, this, [this, axis](int value) {
      move(std::string{axis} + " " + decimal(static_cast<double>(value) / sliderEnd));
    });
    layout.addWidget(lever);
  }
  void addButtons(QBoxLayout& layout) {
    auto* row = new QHBoxLayout;
    layout.addLayout(row);
    for (int i = 1; i <= buttonCount; ++i) {
      auto* button = makeControl<QToolButton>(
          QString{"button%1"}.arg(i), i <= 4   ? "Kicks"
                                      : i == 5 ? "While it is held, the stick moves the head"
                                      : i == 7 ? "Gets up"
                                               : "As the scheme says");
      button->setText(QString::number(i));
      const auto press = [this, i](const char* what) {
        this->session().execute(std::string{"joystick "} + what + " " + std::to_string(i));
      };
      QObject::connect(button, &QToolButton::pressed, this, [press] { press("press"); });
      QObject::connect(button, &QToolButton::released, this, [press] { press("release"); });
      row->addWidget(button);
    }
  }
  void move(const std::string& axes) { session().executeQuietly("joystick " + axes); }

  void show(const Asked& asked) {
    asked_ = false;
    motion_->setText((asked.movesHead ? "The stick moves the head. " : "") + textOf(asked.sent));
    const bool active = asked.known && same(asked.sent, asked.active);
    const QColor gray = palette().color(QPalette::Disabled, QPalette::WindowText);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, !active ? gray
                                          : !same(asked.sent, asked.executed)
                                              ? QColor{200, 30, 30}
                                              : palette().windowText().color());
    motion_->setPalette(colors);
  }

  QCheckBox* use_;
  QComboBox* scheme_;
  StickPad* stick_;
  QLabel* motion_;
  bool asked_ = false;
};

const RegisterDialog<JoystickTester> registeredJoystickTester{
    {.id = "joystick",
     .title = "Joystick motion tester",
     .group = "Robots",
     .help = "Moves the robot by a joystick, or by the stick, levers and buttons shown here",
     .report = "J.5.5",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
