#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/IconButton.h"

namespace gt {
namespace {

constexpr int timeSteps = 1000;

/// Report J.2.4: plays the log that the connected robot runs on, and records what robots send.
class LogPlayerToolbar : public Dialog {
 public:
  explicit LogPlayerToolbar(SessionThread& session) : Dialog{session} {
    auto* layout = new QHBoxLayout{this};
    layout->setContentsMargins(2, 0, 2, 0);
    const auto button = [&](auto... what) { return addIconButton(*layout, *this, what...); };
    button("open", QStyle::SP_DialogOpenButton, "Lets a robot run on a log",
           [this] { chooseFile(); });
    player_ = {
        button("back", QStyle::SP_MediaSeekBackward, "One moment back", [this] { play("back"); }),
        play_ = button("play", QStyle::SP_MediaPlay, "Plays the log while time passes, or not",
                       [this] { playOrPause(); }),
        button("forward", QStyle::SP_MediaSeekForward, "One moment on", [this] { play("step"); }),
        button("begin", QStyle::SP_MediaStop, "Stops, and goes to the log's begin", [this] {
          play("pause");
          play("message 0");
        })};
    slider_ = makeControl<QSlider>("position", "Where in the log it is", Qt::Horizontal);
    slider_->setRange(0, timeSteps);
    slider_->setMinimumWidth(160);
    QObject::connect(slider_, &QSlider::sliderMoved, this, [this](int at) { wanted_ = at; });
    QObject::connect(slider_, &QSlider::actionTriggered, this,
                     [this](int) { wanted_ = slider_->sliderPosition(); });
    layout->addWidget(slider_);
    place_ = new QLabel;
    place_->setObjectName("place");
    place_->setMinimumWidth(150);
    layout->addWidget(place_);
    speed_ = makeControl<QComboBox>("speed", "How fast the log's time passes");
    for (const double factor : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0})
      speed_->addItem(QString::number(factor) + "×", factor);
    QObject::connect(speed_, &QComboBox::activated, this, [this](int index) {
      play("speed " + speed_->itemData(index).toString().toStdString());
    });
    layout->addWidget(speed_);
    loop_ = makeControl<QToolButton>("loop", "Begins anew at the log's end");
    loop_->setText("Loop");
    loop_->setCheckable(true);
    QObject::connect(loop_, &QToolButton::clicked, this,
                     [this](bool on) { play(on ? "loop on" : "loop off"); });
    layout->addWidget(loop_);
    player_ << slider_ << speed_ << loop_;
    for (QWidget* part : player_) part->setEnabled(false);  // until a log is there
    layout->addSpacing(8);
    record_ = makeControl<QToolButton>("record", "Records all that the connected robots send");
    record_->setText("Record");
    record_->setCheckable(true);
    QObject::connect(record_, &QToolButton::clicked, this,
                     [this](bool on) { this->session().execute(on ? "log start" : "log stop"); });
    layout->addWidget(record_);
    button("save", QStyle::SP_DialogSaveButton, "Saves what was recorded as a log", [this] {
      const QString file = QFileDialog::getSaveFileName(this, "Save what was recorded",
                                                        "out/logs/record.mcap", "Logs (*.mcap)");
      if (!file.isEmpty()) this->session().execute("log save \"" + file.toStdString() + "\"");
    });
  }

  void refresh() override {
    const auto log = session().status().log;
    for (QWidget* part : player_) part->setEnabled(log.has_value());
    if (!log) {
      place_->setText("No robot on a log is connected");
      return;
    }
    robot_ = log->robot;
    playing_ = log->playing && session().status().started;
    play_->showIcon(playing_ ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay);
    loop_->setChecked(log->loop);
    place_->setText(QString{"%1 of %2 s"}
                        .arg(log->now - log->begin, 0, 'f', 2)
                        .arg(log->end - log->begin, 0, 'f', 2));
    if (const int index = speed_->findData(log->speed); index >= 0) speed_->setCurrentIndex(index);
    const double length = std::max(log->end - log->begin, 1e-3);
    if (wanted_) {
      // One at a time: a hand moves faster than a log is read.
      if (session().busy()) return;
      play("time " + std::to_string(log->begin + length * *wanted_ / timeSteps));
      wanted_.reset();
    } else if (!slider_->isSliderDown() && !session().busy()) {
      slider_->setValue(
          static_cast<int>(std::lround(timeSteps * (log->now - log->begin) / length)));
    }
  }

 private:
  void play(const std::string& what) {
    if (!robot_.empty()) session().executeFor(robot_, "lp " + what);
  }
  void playOrPause() {
    play(playing_ ? "pause" : "play");
    if (!playing_ && !session().status().started) session().execute("start");
  }
  void chooseFile() {
    const QString file = QFileDialog::getOpenFileName(this, "Open a log", "out/logs",
                                                      "Logs (*.mcap *.log);;All (*)");
    if (file.isEmpty()) return;
    const std::string name =
        "log-" + QFileInfo{file}.completeBaseName().replace(' ', '_').toStdString();
    session().execute("sl " + name + " \"" + file.toStdString() + "\"", this,
                      [this, name](const Result<void>& done) {
                        if (done) session().execute("robot " + name);
                      });
  }

  QList<QWidget*> player_;
  IconButton* play_;
  QSlider* slider_;
  QLabel* place_;
  QComboBox* speed_;
  QToolButton* loop_;
  QToolButton* record_;
  std::optional<int> wanted_;  ///< Where the slider was moved.
  std::string robot_;
  bool playing_ = false;
};

const RegisterDialog<LogPlayerToolbar> registeredLogPlayerToolbar{
    {.id = "logPlayer",
     .title = "Log player",
     .group = "Toolbars",
     .help = "Plays the log that the connected robot runs on; records what robots send",
     .report = "J.2.4",
     .place = DialogPlace::toolbar}};

}  // namespace
}  // namespace gt
