#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <set>
#include <utility>

#include "representations/behavior/MotionRequest.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "xabsl/language/Model.h"

namespace gt {
namespace {

/// What has a name and parameters: an option or a basic behavior.
struct Element {
  QString name;
  bool basicBehavior = false;
  struct Parameter {
    QString name, unit;
    QStringList values;  ///< Empty: a number.
  };
  std::vector<Parameter> parameters{};
};
struct OutputSymbol {
  QString name;
  QStringList values;
};
/// What can be asked of a behavior.
struct BehaviorParts {
  std::vector<Element> elements;
  std::vector<OutputSymbol> outputs;
  QStringList inputs;
  QString error;
};

QStringList valuesOf(const xabsl::Model& model, xabsl::Type type) {
  QStringList values;
  if (type.kind == xabsl::ValueKind::boolean)
    values << "false"
           << "true";
  if (type.kind == xabsl::ValueKind::enumeration)
    for (const auto& element :
         model.enumerations[static_cast<std::size_t>(type.enumeration)].elements)
      values << QString::fromStdString(element.name);
  return values;
}

template <typename T>
void addElements(const xabsl::Model& model, const std::vector<T>& from, bool basicBehavior,
                 std::vector<Element>& to) {
  const auto begin = static_cast<std::ptrdiff_t>(to.size());
  for (const T& known : from) {
    Element element{QString::fromStdString(known.name), basicBehavior};
    for (const xabsl::Parameter& parameter : known.parameters)
      element.parameters.push_back({QString::fromStdString(parameter.name),
                                    QString::fromStdString(parameter.unit),
                                    valuesOf(model, parameter.type)});
    to.push_back(std::move(element));
  }
  std::sort(to.begin() + begin, to.end(),
            [](const Element& a, const Element& b) { return a.name < b.name; });
}

BehaviorParts partsOf(Console& console) {
  BehaviorParts parts;
  const auto found = console.behavior();
  if (!found) {
    parts.error = QString::fromStdString(found.error().text());
    return parts;
  }
  const xabsl::Model& model = **found;
  addElements(model, model.options, false, parts.elements);
  addElements(model, model.behaviors, true, parts.elements);
  for (const xabsl::Symbol& symbol : model.symbols) {
    if (!symbol.parameters.empty()) continue;
    const QString name = QString::fromStdString(symbol.name);
    if (symbol.kind == xabsl::SymbolKind::input)
      parts.inputs << name;
    else
      parts.outputs.push_back({name, valuesOf(model, symbol.type)});
  }
  parts.inputs.sort();
  std::ranges::sort(parts.outputs, {}, &OutputSymbol::name);
  return parts;
}

/// The motion that the behavior of the connected robot requests.
QString motionOf(Console& console) {
  const auto robot = console.firstRobot();
  if (!robot) return "–";
  const auto found = (*robot)->observed().value<MotionRequest>();
  if (!found) return "–";
  const MotionRequest& request = **found;
  if (request.type == MotionType::specialAction)
    return QString::fromStdString(request.specialAction);
  const QString type = QString::fromStdString(std::string{enumName(request.type)});
  if (request.type != MotionType::walk) return type;
  return QString{"%1 %2, %3 and %4 mm/s, %5°/s"}
      .arg(type, QString::fromStdString(std::string{enumName(request.walkType)}))
      .arg(request.walk.translation.x(), 0, 'f', 0)
      .arg(request.walk.translation.y(), 0, 'f', 0)
      .arg(toDegrees(request.walk.rotation), 0, 'f', 0);
}

/// Report J.5.1: lets the behavior's engine execute an option or a basic behavior, sets an output
/// symbol, shows symbols. Nothing is sent before the button Send request is pressed.
class BehaviorTester : public Dialog {
 public:
  explicit BehaviorTester(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    element_ = makeControl<QComboBox>(
        "element",
        "What is executed instead of the engine's choice: options, and below the "
        "line basic behaviors");
    element_->setMaxVisibleItems(30);
    layout->addWidget(element_);
    form_ = new QFormLayout;
    layout->addLayout(form_);
    auto* outputs = new QHBoxLayout;
    output_ = makeControl<QComboBox>("output",
                                     "An output symbol that is set, whatever the behavior does");
    value_ = makeControl<QComboBox>("value", "The value that the output symbol is set to");
    value_->setEditable(true);
    outputs->addWidget(output_, 2);
    outputs->addWidget(value_, 1);
    layout->addLayout(outputs);
    auto* buttons = new QHBoxLayout;
    const auto button = [&](auto... what) { addButton(*buttons, *this, what...); };
    button("reload", "Reload files",
           "Reads the behavior's files anew, and sends the behavior to the connected robots",
           [this] { reload(); });
    button("send", "Send request", "Sends what is chosen above", [this] { send(); });
    layout->addLayout(buttons);
    error_ = new QLabel;
    error_->setObjectName("error");
    error_->setWordWrap(true);
    error_->hide();
    layout->addWidget(error_);
    motion_ = makeControl<QLabel>("motion", "The motion request that results");
    layout->addWidget(motion_);
    filter_ = makeControl<QLineEdit>("filter", "Lists only symbols whose names hold these letters");
    filter_->setPlaceholderText("Symbols to show in the behavior viewer");
    filter_->setClearButtonEnabled(true);
    layout->addWidget(filter_);
    symbols_ = new QListWidget;
    symbols_->setObjectName("symbols");
    layout->addWidget(symbols_);
    QObject::connect(filter_, &QLineEdit::textChanged, this, [this](const QString& letters) {
      for (int i = 0; i < symbols_->count(); ++i)
        symbols_->item(i)->setHidden(
            !symbols_->item(i)->text().contains(letters, Qt::CaseInsensitive));
    });
    QObject::connect(element_, &QComboBox::currentTextChanged, this, [this] { showParameters(); });
    QObject::connect(output_, &QComboBox::currentTextChanged, this, [this] { showValues(); });
    QObject::connect(
        symbols_, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
          const bool input = item->data(Qt::UserRole).toBool();
          this->session().execute((input ? "xis " : "xos ") + item->text().toStdString() +
                                  (item->checkState() == Qt::Checked ? " on" : " off"));
        });
  }

  void refresh() override {
    const std::uint64_t beginnings = session().status().beginnings;
    if (std::exchange(beginnings_, beginnings) != beginnings) look();
    const std::uint64_t version = session().version();
    if (asked_ || std::exchange(version_, version) == version) return;
    asked_ = true;
    session().ask(this, motionOf, [this](const QString& motion) {
      asked_ = false;
      motion_->setText("Motion: " + motion);
    });
  }

 private:
  void look() {
    session().ask(this, partsOf, [this](BehaviorParts& parts) { showParts(std::move(parts)); });
  }

  void showParts(BehaviorParts parts) {
    parts_ = std::move(parts);
    error_->setText(parts_.error);
    error_->setVisible(!parts_.error.isEmpty());
    const QString element = element_->currentText(), output = output_->currentText();
    element_->clear();
    element_->addItem("unchanged", -1);
    bool basic = false;
    for (std::size_t i = 0; i < parts_.elements.size(); ++i) {
      if (parts_.elements[i].basicBehavior && !std::exchange(basic, true))
        element_->insertSeparator(element_->count());
      element_->addItem(parts_.elements[i].name, static_cast<int>(i));
    }
    element_->setCurrentIndex(element.isEmpty() ? 0 : std::max(0, element_->findText(element)));
    output_->clear();
    for (const OutputSymbol& symbol : parts_.outputs) output_->addItem(symbol.name);
    output_->setCurrentIndex(std::max(0, output_->findText(output)));
    std::set<QString> checked;
    for (int i = 0; i < symbols_->count(); ++i)
      if (symbols_->item(i)->checkState() == Qt::Checked) checked.insert(symbols_->item(i)->text());
    const QSignalBlocker quiet{symbols_};
    symbols_->clear();
    const auto add = [&](const QString& name, bool input) {
      auto* item = new QListWidgetItem{name, symbols_};
      item->setData(Qt::UserRole, input);
      item->setCheckState(Qt::Unchecked);
      item->setToolTip(input ? "Input symbol" : "Output symbol");
    };
    for (const QString& name : parts_.inputs) add(name, true);
    for (const OutputSymbol& symbol : parts_.outputs) add(symbol.name, false);
    showParameters();
    showValues();
  }

  const Element* element() const {
    const int index = element_->currentData().isValid() ? element_->currentData().toInt() : -1;
    return index < 0 || index >= static_cast<int>(parts_.elements.size())
               ? nullptr
               : &parts_.elements[static_cast<std::size_t>(index)];
  }

  void showParameters() {
    while (form_->rowCount() > 0) form_->removeRow(0);
    fields_.clear();
    const Element* const chosen = element();
    if (!chosen) return;
    for (const Element::Parameter& parameter : chosen->parameters) {
      auto* field = makeControl<QComboBox>(parameter.name, "A parameter of what is executed");
      field->setEditable(parameter.values.isEmpty());
      field->addItems(parameter.values);
      if (parameter.values.isEmpty()) field->setEditText("0");
      form_->addRow(parameter.name + (parameter.unit.isEmpty() ? "" : " [" + parameter.unit + "]"),
                    field);
      fields_ << field;
    }
  }

  void showValues() {
    value_->clear();
    value_->addItem("unchanged");
    for (const OutputSymbol& symbol : parts_.outputs)
      if (symbol.name == output_->currentText()) value_->addItems(symbol.values);
  }

  void send() {
    const Element* const chosen = element();
    if (!chosen) {
      session().execute("xo unchanged");
    } else {
      std::string line = (chosen->basicBehavior ? "xbb " : "xo ") + chosen->name.toStdString();
      for (const QComboBox* field : fields_) line += " " + field->currentText().toStdString();
      session().execute(line);
    }
    if (!output_->currentText().isEmpty() &&
        (value_->currentText() != "unchanged" || set_.contains(output_->currentText()))) {
      set_.insert(output_->currentText());
      session().execute("xos " + output_->currentText().toStdString() + " " +
                        value_->currentText().toStdString());
    }
  }

  void reload() {
    session().ask(
        this,
        [](Console& console) {
          return console.session().behavior.empty() ? console.session().options().behavior
                                                    : console.session().behavior;
        },
        [this](const std::string& file) {
          session().execute("xlb \"" + file + "\"", this, [this](const Result<void>& done) {
            look();
            if (done) return;
            error_->setText(QString::fromStdString(done.error().text()));
            error_->show();
          });
        });
  }

  QComboBox* element_;
  QFormLayout* form_;
  QList<QComboBox*> fields_;  ///< For the parameters.
  QComboBox* output_;
  QComboBox* value_;
  QLabel* error_;
  QLabel* motion_;
  QLineEdit* filter_;
  QListWidget* symbols_;
  BehaviorParts parts_;
  std::set<QString> set_;  ///< Output symbols that were set.
  std::uint64_t beginnings_ = 0, version_ = 0;
  bool asked_ = false;
};

const RegisterDialog<BehaviorTester> registeredBehaviorTester{
    {.id = "behaviorTester",
     .title = "Behavior tester",
     .group = "Robots",
     .help =
         "Has an option or a basic behavior executed, sets output symbols, reloads the behavior",
     .report = "J.5.1",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
