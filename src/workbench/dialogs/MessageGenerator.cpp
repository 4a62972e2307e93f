#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <map>
#include <memory>

#include "representations/RepresentationTypes.h"
#include "streams/Json.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

using Types = std::map<QString, const RepresentationType*>;

/// What may be sent, by name.
const Types& messageTypes() {
  static const Types types = [] {
    Types found;
    for (const RepresentationType* type : representationTypes())
      if (type->type()) found[QString::fromStdString(std::string{type->name})] = type;
    return found;
  }();
  return types;
}

/// Report J.7.1: sends any message, which is written as JSON. Nothing is sent before the button is
/// pressed. What is written is kept for each type.
class MessageGenerator : public Dialog {
 public:
  explicit MessageGenerator(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    type_ = makeControl<QComboBox>("type", "The type of the message");
    for (const auto& [name, type] : messageTypes()) type_->addItem(name);
    QObject::connect(type_, &QComboBox::currentTextChanged, this, [this] { showText(); });
    layout->addWidget(type_);
    text_ = makeControl<QPlainTextEdit>(
        "text", "Its fields as JSON; those that are not mentioned have their defaults");
    QObject::connect(text_, &QPlainTextEdit::textChanged, this,
                     [this] { texts_[type_->currentText()] = text_->toPlainText(); });
    layout->addWidget(text_, 1);
    fault_ = new QLabel;
    fault_->setObjectName("fault");
    fault_->setWordWrap(true);
    layout->addWidget(fault_);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    addButton(*row, *this, "fromRobot", "From robot", "Takes the robot's value of now",
              [this] { takeFromRobot(); });
    addButton(*row, *this, "send", "Send", "Sends the message to the connected robots",
              [this] { send(); });
    showText();
  }

  QJsonObject settings() const override {
    QJsonObject texts;
    for (const auto& [name, text] : texts_) texts[name] = text;
    return {{"type", type_->currentText()}, {"texts", texts}};
  }
  void restore(const QJsonObject& settings) override {
    const QJsonObject texts = settings["texts"].toObject();
    for (const QString& name : texts.keys())
      if (messageTypes().contains(name)) texts_[name] = texts[name].toString();
    type_->setCurrentText(settings["type"].toString());
    showText();
  }
  void refresh() override {}

 private:
  const RepresentationType& chosen() const { return *messageTypes().at(type_->currentText()); }

  /// Shows the text that was written last, or the type's defaults.
  void showText() {
    fault_->clear();
    const auto known = texts_.find(type_->currentText());
    const auto made = chosen().make();
    const QString text =
        known != texts_.end()
            ? known->second
            : QString::fromStdString(detail::jsonText(ConstValue{*chosen().type(), made.get()}, 2));
    const QSignalBlocker quiet{text_};
    text_->setPlainText(text);
  }
  void takeFromRobot() {
    session().ask(
        this,
        [name = std::string{chosen().name}](Console& console) -> Result<std::string> {
          const auto robot = console.firstRobot();
          if (!robot) return robot.error();
          const auto value = (*robot)->observed().value(name);
          if (!value) return value.error();
          return detail::jsonText(*value, 2);
        },
        [this](const Result<std::string>& text) {
          fault_->setText(text ? "" : QString::fromStdString(text.error().text()));
          if (text) text_->setPlainText(QString::fromStdString(*text));
        });
  }
  void send() {
    std::shared_ptr<void> message = chosen().make();
    const auto done = detail::readJson(text_->toPlainText().toStdString(), "message",
                                       Value{chosen().type(), message.get()});
    fault_->setText(done ? "" : QString::fromStdString(done.error().text()));
    if (!done) return;
    session().change([message, type = &chosen()](Console& console) {
      const std::string what = "a " + std::string{type->name};
      console.session().match().markIrreproducible(what + " was sent by hand");
      const auto sent = console.forEachRobot(
          [&](ConsoleRobot& robot) { return robot.observed().send(*type, message.get()); });
      console.print(sent ? what + " was sent." : "error: " + sent.error().text());
    });
  }

  QComboBox* type_;
  QPlainTextEdit* text_;
  QLabel* fault_;
  std::map<QString, QString> texts_;
};

const RegisterDialog<MessageGenerator> registeredMessageGenerator{
    {.id = "messages",
     .title = "Debug message generator",
     .group = "Robots",
     .help = "Sends any message to the robot, written as JSON",
     .report = "J.7.1",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
