#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>

#include "representations/behavior/MotionRequest.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

struct Axis {
  const char* name;
  const char* text;
  const char* unit;
  int most;
};
constexpr Axis axes[] = {
    {"x", "Ahead", "mm/s", 400}, {"y", "Left", "mm/s", 400}, {"r", "Counterclockwise", "°/s", 200}};

/// Report J.5.2: motion requests by hand. Nothing is sent before the button Send is pressed.
class MotionTester : public Dialog {
 public:
  explicit MotionTester(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* grid = new QGridLayout;
    layout->addLayout(grid);
    motion_ =
        makeControl<QComboBox>("motion", "Stand, get up, a type of walking, or a special action");
    grid->addWidget(new QLabel{"Motion"}, 0, 0);
    grid->addWidget(motion_, 0, 1, 1, 2);
    int row = 1;
    for (const Axis& axis : axes) {
      auto* slider = makeControl<QSlider>(
          axis.name, QString{"The speed of the walk, in %1"}.arg(axis.unit), Qt::Horizontal);
      slider->setRange(-axis.most, axis.most);
      slider->setPageStep(axis.most / 8);
      auto* value = new QLabel;
      value->setMinimumWidth(70);
      value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
      const auto show = [this, value, &axis](int speed) {
        value->setText(QString{"%1 %2"}.arg(speed).arg(axis.unit));
        if (follow_ && follow_->isChecked()) send();
      };
      show(0);
      QObject::connect(slider, &QSlider::valueChanged, this, show);
      grid->addWidget(new QLabel{axis.text}, row, 0);
      grid->addWidget(slider, row, 1);
      grid->addWidget(value, row, 2);
      sliders_ << slider;
      ++row;
    }
    tail_ = makeControl<QComboBox>("tail", "What the tail shall do");
    tail_->addItem("unchanged");
    for (const std::string_view name : enumNames<TailRequest>)
      tail_->addItem(QString::fromStdString(std::string{name}));
    grid->addWidget(new QLabel{"Tail"}, row, 0);
    grid->addWidget(tail_, row, 1, 1, 2);
    auto* buttons = new QHBoxLayout;
    layout->addLayout(buttons);
    const auto button = [&](auto... what) { addButton(*buttons, *this, what...); };
    button("takeOver", "Take over", "Disables BehaviorControl, so that requests by hand last",
           [this] { this->session().execute("sr BehaviorControl disabled"); });
    button("stop", "Stop", "Has the robot stand", [this] {
      for (QSlider* slider : sliders_) {
        const QSignalBlocker quiet{slider};
        slider->setValue(0);
      }
      this->session().execute("mr stand");
    });
    button("send", "Send", "Sends the request to the connected robot", [this] { send(); });
    follow_ = makeControl<QCheckBox>("follow", "Sends the request whenever a slider is moved",
                                     "Send while sliders are moved");
    layout->addWidget(follow_);
    layout->addStretch();
    QObject::connect(motion_, &QComboBox::currentTextChanged, this, [this] { enable(); });
  }

  void refresh() override {
    const std::uint64_t beginnings = session().status().beginnings;
    if (beginnings == beginnings_) return;
    beginnings_ = beginnings;
    session().ask(
        this, [](Console& console) { return console.completions("mr "); },
        [this](const std::vector<std::string>& names) {
          const QString chosen = motion_->currentText();
          motion_->clear();
          for (const std::string& name : names)
            if (name != "?") motion_->addItem(QString::fromStdString(name));
          motion_->setCurrentText(chosen.isEmpty() ? "normal" : chosen);
          enable();
        });
  }

 private:
  bool walks() const {
    return enumValue<WalkType>(motion_->currentText().toStdString()).has_value();
  }
  void enable() {
    for (QSlider* slider : sliders_) slider->setEnabled(walks());
  }
  void send() {
    if (motion_->currentText().isEmpty()) return;
    std::string line = "mr " + motion_->currentText().toStdString();
    if (walks())
      for (const QSlider* slider : sliders_) line += " " + std::to_string(slider->value());
    session().execute(line);
    if (tail_->currentIndex() > 0) session().execute("tr " + tail_->currentText().toStdString());
  }

  QComboBox* motion_;
  QList<QSlider*> sliders_;
  QComboBox* tail_;
  QCheckBox* follow_ = nullptr;
  std::uint64_t beginnings_ = 0;
};

const RegisterDialog<MotionTester> registeredMotionTester{
    {.id = "motion",
     .title = "Motion tester",
     .group = "Robots",
     .help = "Has the robot walk, stand up, or execute a special action by hand",
     .report = "J.5.2",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
