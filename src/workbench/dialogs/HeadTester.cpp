#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include "representations/behavior/HeadControlMode.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Joints of the head and how far they turn, in degrees (facts, 1.2).
struct HeadJoint {
  const char* name;
  const char* text;
  int low, high;
};
constexpr HeadJoint joints[] = {{"tilt", "Tilt", -82, 43},
                                {"pan", "Pan", -89, 89},
                                {"roll", "Roll", -29, 29},
                                {"mouth", "Mouth", -47, 0}};

/// Report J.5.3: head control modes and head motion requests by hand. Angles are sent while the
/// mode is none.
class HeadTester : public Dialog {
 public:
  explicit HeadTester(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* grid = new QGridLayout;
    layout->addLayout(grid);
    mode_ = makeControl<QComboBox>("mode", "What the head shall do");
    for (const std::string_view name : enumNames<HeadMode>)
      mode_->addItem(QString::fromStdString(std::string{name}));
    grid->addWidget(new QLabel{"Mode"}, 0, 0);
    grid->addWidget(mode_, 0, 1, 1, 2);
    int row = 1;
    for (const char* name : {"pointX", "pointY", "pointZ"}) {
      auto* box = number(name, "A coordinate of the point that is looked at", -5000, 5000, " mm");
      point_ << add(*grid, row++, QString{"Point "} + name[5], box);
    }
    pointBoxes_[0]->setValue(1000);
    scan_ << add(*grid, row++, "Scan at tilt",
                 number("scanTilt", "The head's tilt while it scans", -80, 40, "°"));
    scan_ << add(*grid, row++, "to each side",
                 number("scanRange", "How far the head turns to each side", 0, 90, "°"));
    pointBoxes_[4]->setValue(45);
    for (const HeadJoint& joint : joints) {
      auto* slider = makeControl<QSlider>(
          joint.name, QString{"Angle of the head's %1"}.arg(QString{joint.text}.toLower()),
          Qt::Horizontal);
      slider->setRange(joint.low, joint.high);
      auto* value = new QLabel{"0°"};
      value->setMinimumWidth(40);
      QObject::connect(slider, &QSlider::valueChanged, this, [this, value](int degrees) {
        value->setText(QString{"%1°"}.arg(degrees));
        if (modeIs(HeadMode::none)) sendAngles();
      });
      angles_ << add(*grid, row, joint.text, slider);
      angles_.back() << value;
      grid->addWidget(value, row++, 2);
      sliders_ << slider;
    }
    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    const auto button = [&](auto... what) { addButton(*buttons, *this, what...); };
    button("takeOver", "Take over", "Disables BehaviorControl, so that requests by hand last",
           [this] { this->session().execute("sr BehaviorControl disabled"); });
    button("send", "Send", "Sends the mode to the connected robot", [this] { send(); });
    layout->addStretch();
    QObject::connect(mode_, &QComboBox::currentTextChanged, this, [this] { showParts(); });
    showParts();
  }

  void refresh() override {}

 private:
  bool modeIs(HeadMode mode) const { return mode_->currentIndex() == static_cast<int>(mode); }
  QSpinBox* number(const char* name, const char* help, int low, int high, const char* unit) {
    auto* box = makeControl<QSpinBox>(name, help);
    box->setRange(low, high);
    box->setSuffix(unit);
    pointBoxes_ << box;
    return box;
  }
  static QList<QWidget*> add(QGridLayout& grid, int row, const QString& text, QWidget* widget) {
    auto* label = new QLabel{text};
    grid.addWidget(label, row, 0);
    grid.addWidget(widget, row, 1);
    return {label, widget};
  }
  /// Shows the input elements of the mode.
  void showParts() {
    const auto show = [](const QList<QList<QWidget*>>& rows, bool on) {
      for (const auto& row : rows)
        for (QWidget* widget : row) widget->setVisible(on);
    };
    show(point_, modeIs(HeadMode::lookAtPoint));
    show(scan_, modeIs(HeadMode::scanLeftRight));
    show(angles_, modeIs(HeadMode::none));
  }
  void send() {
    std::string line = "hcm " + mode_->currentText().toStdString();
    const auto addNumbers = [&](qsizetype from, qsizetype to) {
      for (qsizetype i = from; i < to; ++i) line += " " + std::to_string(pointBoxes_[i]->value());
    };
    if (modeIs(HeadMode::lookAtPoint)) addNumbers(0, 3);
    if (modeIs(HeadMode::scanLeftRight)) addNumbers(3, 5);
    session().execute(line);
    if (modeIs(HeadMode::none)) sendAngles();
  }
  void sendAngles() {
    std::string line = "hmr";
    for (const QSlider* slider : sliders_) line += " " + std::to_string(slider->value());
    session().execute(line);
  }

  QComboBox* mode_;
  QList<QSpinBox*> pointBoxes_;
  QList<QSlider*> sliders_;
  QList<QList<QWidget*>> point_, scan_, angles_;  ///< Rows of the form.
};

const RegisterDialog<HeadTester> registeredHeadTester{
    {.id = "head",
     .title = "Head motion tester",
     .group = "Robots",
     .help = "Sets the head control mode, or the joints of the head, by hand",
     .report = "J.5.3",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
