#include <QAbstractItemView>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Report J.2.6: what a game manager does.
class GameToolbar : public Dialog {
 public:
  explicit GameToolbar(SessionThread& session) : Dialog{session} {
    auto* layout = new QHBoxLayout{this};
    layout->setContentsMargins(2, 0, 2, 0);
    const auto order = [this](const char* what) {
      return [this, what] { this->session().execute(std::string{"gc "} + what); };
    };
    addButton<QToolButton>(*layout, *this, "initial", "Initial",
                           "Begins the game anew; the score is cleared", order("reset"));
    addButton<QToolButton>(*layout, *this, "ready", "Ready",
                           "Robots go to their places; all penalties are lifted", order("ready"));
    kickOff_ = makeControl<QComboBox>("kickOff", "Whose kick-off it is");
    kickOff_->addItems({"red", "blue"});
    red_ = score("red");
    blue_ = score("blue");
    addButton<QToolButton>(
        *layout, *this, "set", "Set",
        "Stops all robots for the kick-off of the chosen team, at this score", [this] {
          this->session().execute("gc kickOff " + kickOff_->currentText().toStdString() + " " +
                                  std::to_string(blue_->value()) + " " +
                                  std::to_string(red_->value()));
        });
    layout->addWidget(kickOff_);
    layout->addWidget(red_);
    layout->addWidget(new QLabel{":"});
    layout->addWidget(blue_);
    addButton<QToolButton>(*layout, *this, "playing", "Playing", "The game goes on",
                           order("playing"));
    addButton<QToolButton>(*layout, *this, "finished", "Finished", "Ends the game", order("final"));
    player_ = makeControl<QComboBox>("player", "The robot that is penalized");
    player_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    layout->addWidget(player_);
    penalty_ = makeControl<QComboBox>("penalty", "For what it is penalized");
    penalty_->addItems({"illegalDefender", "obstruction", "keeperCharged", "ballHolding",
                        "fieldPlayerCharged", "illegalDefense", "requestForPickup"});
    penalty_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    penalty_->setMinimumContentsLength(10);
    penalty_->view()->setMinimumWidth(150);
    layout->addWidget(penalty_);
    addButton<QToolButton>(*layout, *this, "penalize", "Penalize", "Penalizes the robot",
                           [this] { penalize("pr " + penalty_->currentText().toStdString()); });
    addButton<QToolButton>(*layout, *this, "continue", "Continue", "Lifts the robot's penalty",
                           [this] { penalize("pr continue"); });
    layout->addWidget(new QLabel{"Speed"});
    gameSpeed_ = makeControl<QSlider>(
        "gameSpeed", "Factor on the speeds at which all robots walk, 0.1 to 1", Qt::Horizontal);
    gameSpeed_->setRange(1, 10);
    gameSpeed_->setValue(10);
    gameSpeed_->setFixedWidth(60);
    QObject::connect(gameSpeed_, &QSlider::valueChanged, this, [this](int tenths) {
      const std::string command = "gs " + QString::number(tenths / 10.0).toStdString();
      this->session().execute("to allSimulatedRobots " + command);
      for (const RobotInfo& robot : this->session().status().robots)
        if (robot.kind == RobotKind::physical)
          return this->session().execute("to allPhysicalRobots " + command);
    });
    layout->addWidget(gameSpeed_);
  }

  void refresh() override {
    const SessionStatus status = session().status();
    if (!red_->hasFocus() && !blue_->hasFocus()) {
      red_->setValue(status.score[0]);
      blue_->setValue(status.score[1]);
    }
    QStringList names;
    for (const RobotInfo& robot : status.robots) names << QString::fromStdString(robot.name);
    if (names == names_ || player_->view()->isVisible()) return;
    names_ = names;
    player_->clear();
    player_->addItems(names);
  }

 private:
  QSpinBox* score(const char* name) {
    auto* box = makeControl<QSpinBox>(name, QString{"Goals of the %1 team"}.arg(name), this);
    box->setRange(0, 99);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setFixedWidth(32);
    return box;
  }
  void penalize(const std::string& command) {
    if (player_->count() > 0) session().executeFor(player_->currentText().toStdString(), command);
  }

  QComboBox* kickOff_;
  QSpinBox* red_;
  QSpinBox* blue_;
  QComboBox* player_;
  QComboBox* penalty_;
  QSlider* gameSpeed_;
  QStringList names_;
};

const RegisterDialog<GameToolbar> registeredGameToolbar{
    {.id = "game",
     .title = "Game",
     .group = "Toolbars",
     .help = "States of the game, kick-off, score, penalties, game speed",
     .report = "J.2.6",
     .place = DialogPlace::toolbar,
     .atFirst = true}};

}  // namespace
}  // namespace gt
