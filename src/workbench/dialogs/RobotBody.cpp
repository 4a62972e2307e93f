#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Switches by where they are on the robot.
struct SwitchPlace {
  const char* name;
  const char* text;
  int row, column;
};
constexpr SwitchPlace switches[] = {{"headFront", "Head, front", 0, 1},
                                    {"headBack", "Head, back", 1, 1},
                                    {"chin", "Chin", 0, 0},
                                    {"back", "Back", 2, 1},
                                    {"pawFL", "Paw, fore left", 1, 0},
                                    {"pawFR", "Paw, fore right", 1, 2},
                                    {"pawHL", "Paw, hind left", 3, 0},
                                    {"pawHR", "Paw, hind right", 3, 2}};

/// Report J.4: handles a simulated robot: presses its switches, throws it over, puts it back on its
/// feet; and selects the data that the simulator sends to it.
class RobotBodyDialog : public Dialog {
 public:
  explicit RobotBodyDialog(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* grid = new QGridLayout;
    layout->addLayout(grid);
    latch_ = makeControl<QCheckBox>(
        "latch", "A switch that is clicked stays pressed until it is clicked again",
        "Switches stay pressed");
    for (const SwitchPlace& place : switches) {
      auto* button = makeControl<QToolButton>(
          place.name, "Pressed as long as it is held, or until it is pressed again");
      button->setText(place.text);
      button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
      const auto press = [this, name = std::string{place.name}](bool on) {
        this->session().execute("press " + name + (on ? " on" : " off"));
      };
      QObject::connect(button, &QToolButton::pressed, this, [this, press] {
        if (!latch_->isChecked()) press(true);
      });
      QObject::connect(button, &QToolButton::released, this, [this, press] {
        if (!latch_->isChecked()) press(false);
      });
      QObject::connect(button, &QToolButton::toggled, this, press);
      QObject::connect(latch_, &QCheckBox::toggled, button, [button](bool on) {
        button->setChecked(false);
        button->setCheckable(on);
      });
      grid->addWidget(button, place.row, place.column);
    }
    layout->addWidget(latch_);
    auto* fall = new QHBoxLayout;
    layout->addLayout(fall);
    direction_ = makeControl<QComboBox>("direction", "On which side the robot is thrown");
    direction_->addItems({"left", "right", "nose", "back", "sitting"});
    addButton(*fall, *this, "throw", "Throw over", "Throws the robot on a side, or makes it sit",
              [this] { forSelected("throw ", " " + direction_->currentText().toStdString()); });
    fall->addWidget(direction_);
    addButton(*fall, *this, "stand", "Put on its feet", "Puts the robot back on its feet",
              [this] { forSelected("stand ", ""); });
    images_ = box("images", "Camera images", "ci ",
                  "Whether the simulator calculates images for the connected robots", true);
    oracle_ =
        box("oracle", "Oracled world states", "so ",
            "Whether the simulator gives the connected robots the truth: to solutions Oracled "
            "and in place of disabled tasks",
            false);
    layout->addWidget(images_);
    layout->addWidget(oracle_);
    layout->addStretch();
  }

  void refresh() override {
    // A session that began anew has all as at the start.
    const std::uint64_t beginnings = session().status().beginnings;
    if (beginnings == beginnings_) return;
    beginnings_ = beginnings;
    for (QCheckBox* known : {images_, oracle_}) {
      const QSignalBlocker quiet{known};
      known->setChecked(known == images_);
    }
    for (QToolButton* known : findChildren<QToolButton*>()) {
      const QSignalBlocker quiet{known};
      known->setChecked(false);
    }
  }

 private:
  QCheckBox* box(const char* name, const char* text, const std::string& command, const char* help,
                 bool on) {
    auto* made = makeControl<QCheckBox>(name, help, text);
    made->setChecked(on);
    QObject::connect(made, &QCheckBox::toggled, this, [this, command](bool checked) {
      session().execute(command + (checked ? "on" : "off"));
    });
    return made;
  }
  void forSelected(const std::string& command, const std::string& rest) {
    for (const RobotInfo& robot : session().status().robots)
      if (robot.selected && robot.inScene) session().execute(command + robot.name + rest);
  }

  QCheckBox* latch_;
  QComboBox* direction_;
  QCheckBox* images_;
  QCheckBox* oracle_;
  std::uint64_t beginnings_ = 0;
};

const RegisterDialog<RobotBodyDialog> registeredRobotBodyDialog{
    {.id = "body",
     .title = "Robot by hand",
     .group = "Simulator",
     .help = "Presses the robot's switches, throws it over, puts it on its feet",
     .report = "J.4",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
