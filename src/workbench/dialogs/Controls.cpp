#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QJsonArray>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int sliderSteps = 200;
constexpr const char* sliderPlace = "%1";  ///< Of a slider's value in its line.

/// A button or slider that executes a line of the console; with %1 in the line it is a slider.
struct Control {
  QString text, line, key;
  double low = 0, high = 1, value = 0;

  bool slides() const { return line.contains(sliderPlace); }
  QJsonObject json() const {
    return {{"text", text}, {"line", line}, {"key", key},
            {"low", low},   {"high", high}, {"value", value}};
  }
  static Control from(const QJsonObject& json) {
    return {json["text"].toString(), json["line"].toString(),  json["key"].toString(),
            json["low"].toDouble(),  json["high"].toDouble(1), json["value"].toDouble()};
  }
};

/// Asks for a control, beginning with one; empty if that is canceled.
std::optional<Control> edited(QWidget* parent, Control control) {
  QDialog dialog{parent};
  dialog.setWindowTitle("Button or slider");
  auto* form = new QFormLayout{&dialog};
  auto* text = makeControl<QLineEdit>("text", "What stands on the button, or beside the slider",
                                      control.text);
  auto* line = makeControl<QLineEdit>("line", "A line of the console; %1 is the value of a slider",
                                      control.line);
  line->setPlaceholderText("place ball 0 0, or set … %1");
  auto* key = makeControl<QKeySequenceEdit>("key", "The key that presses the button",
                                            QKeySequence{control.key});
  const auto number = [](const char* name, const char* help, double value) {
    auto* box = makeControl<QDoubleSpinBox>(name, help);
    box->setRange(-1e6, 1e6);
    box->setDecimals(3);
    box->setValue(value);
    return box;
  };
  auto* low = number("low", "The value at the left end", control.low);
  auto* high = number("high", "The value at the right end", control.high);
  form->addRow("Text", text);
  form->addRow("Console line", line);
  form->addRow("Key", key);
  form->addRow("Slider from", low);
  form->addRow("to", high);
  auto* buttons = new QDialogButtonBox{QDialogButtonBox::Ok | QDialogButtonBox::Cancel};
  form->addRow(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  if (dialog.exec() != QDialog::Accepted || line->text().trimmed().isEmpty()) return std::nullopt;
  control.text = text->text().isEmpty() ? line->text() : text->text();
  control.line = line->text().trimmed();
  control.key = key->keySequence().toString(QKeySequence::PortableText);
  control.low = low->value();
  control.high = std::max(high->value(), control.low);
  return control;
}

/// Buttons and sliders of one's own, bound to lines of the console; layouts keep them.
class Controls : public Dialog {
 public:
  explicit Controls(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    rows_ = new QVBoxLayout;
    layout->addLayout(rows_);
    layout->addStretch();
    auto* bottom = new QHBoxLayout;
    layout->addLayout(bottom);
    bottom->addStretch();
    addButton(*bottom, *this, "add", "Add…",
              "Adds a button, or a slider if its console line holds %1", [this] {
                if (const auto made = edited(this, {})) {
                  controls_.push_back(*made);
                  showControls();
                }
              });
  }

  QJsonObject settings() const override {
    QJsonArray list;
    for (const Control& control : controls_) list.append(control.json());
    return {{"controls", list}};
  }
  void restore(const QJsonObject& settings) override {
    controls_.clear();
    for (const QJsonValue control : settings["controls"].toArray())
      controls_.push_back(Control::from(control.toObject()));
    showControls();
  }
  void refresh() override {}

 private:
  void showControls() {
    for (QWidget* row : shown_) row->deleteLater();
    shown_.clear();
    for (std::size_t i = 0; i < controls_.size(); ++i) {
      QWidget* const row = controls_[i].slides() ? slider(i) : button(i);
      row->setContextMenuPolicy(Qt::CustomContextMenu);
      QObject::connect(row, &QWidget::customContextMenuRequested, this,
                       [this, row, i](const QPoint& at) { showMenu(i, row->mapToGlobal(at)); });
      rows_->addWidget(row);
      shown_ << row;
    }
  }

  QWidget* button(std::size_t index) {
    const Control& control = controls_[index];
    auto* made =
        makeControl<QPushButton>("control" + QString::number(index), control.line, control.text);
    QObject::connect(made, &QPushButton::clicked, this,
                     [this, line = control.line] { session().execute(line.toStdString()); });
    if (!control.key.isEmpty()) {
      // A key works wherever the focus is in the window.
      auto* action = new QAction{made};
      action->setShortcut(QKeySequence{control.key});
      QObject::connect(action, &QAction::triggered, made, &QPushButton::click);
      made->addAction(action);
      made->setToolTip(control.line + " (" + control.key + ")");
    }
    return made;
  }

  QWidget* slider(std::size_t index) {
    const Control& control = controls_[index];
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout{row};
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new QLabel{control.text});
    auto* made =
        makeControl<QSlider>("control" + QString::number(index), control.line, Qt::Horizontal);
    made->setRange(0, sliderSteps);
    const double width = std::max(control.high - control.low, 1e-9);
    made->setValue(
        static_cast<int>(std::lround((control.value - control.low) / width * sliderSteps)));
    layout->addWidget(made, 1);
    auto* number = new QLabel{QString::number(control.value)};
    number->setMinimumWidth(60);
    layout->addWidget(number);
    QObject::connect(made, &QSlider::valueChanged, this, [this, index, number](int step) {
      Control& moved = controls_[index];
      moved.value = moved.low + (moved.high - moved.low) * step / sliderSteps;
      number->setText(QString::number(moved.value));
      QString line = moved.line;
      line.replace(sliderPlace, QString::number(moved.value));
      // The newest value counts: what waits is not executed.
      wanted_ = line.toStdString();
      if (!std::exchange(sending_, true)) send();
    });
    return row;
  }
  void send() {
    session().execute(std::exchange(wanted_, {}), this, [this](const Result<void>&) {
      if (wanted_.empty())
        sending_ = false;
      else
        send();
    });
  }

  void showMenu(std::size_t index, const QPoint& at) {
    QMenu menu;
    menu.addAction("Edit…", this, [this, index] {
      if (const auto changed = edited(this, controls_[index])) {
        controls_[index] = *changed;
        showControls();
      }
    });
    menu.addAction("Remove", this, [this, index] {
      controls_.erase(controls_.begin() + static_cast<std::ptrdiff_t>(index));
      showControls();
    });
    menu.exec(at);
  }

  QVBoxLayout* rows_;
  QList<QWidget*> shown_;
  std::vector<Control> controls_;
  std::string wanted_;  ///< Of a slider, to be executed next.
  bool sending_ = false;
};

const RegisterDialog<Controls> registeredControls{
    {.id = "controls",
     .title = "Controls",
     .group = "Session",
     .help = "Buttons and sliders of one's own, bound to lines of the console",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
