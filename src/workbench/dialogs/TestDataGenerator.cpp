#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <map>

#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr qsizetype mostNumbers = 10;  // report E.2

/// A solution that takes numbers, and its parameters that the first ten numbers become.
struct TestDataType {
  QString id;
  bool active = false;
  std::vector<ParameterDescription> parameters;
};

QStringList wordsOf(const std::string& value) {
  return QString::fromStdString(value).split(' ', Qt::SkipEmptyParts);
}

/// Whether a word is a number or a switch, which is sent as 1 or 0.
bool isNumber(const QString& word) {
  bool fine = false;
  word.toDouble(&fine);
  return fine || word == "true" || word == "false";
}

std::vector<TestDataType> typesOf(Console& console) {
  std::vector<TestDataType> types;
  const auto robot = console.firstRobot();
  if (!robot) return types;
  const auto processes = (*robot)->observed().processes();
  if (!processes) return types;
  for (const ProcessDescription& process : **processes)
    for (const TaskDescription& task : process.tasks)
      for (const SolutionDescription& solution : task.solutions) {
        TestDataType type{QString::fromStdString(task.name + "." + solution.name),
                          task.active == solution.name,
                          {}};
        qsizetype numbers = 0;
        for (const ParameterDescription& parameter : solution.parameters) {
          const QStringList words = wordsOf(parameter.value);
          numbers += words.size();
          if (numbers > mostNumbers || !std::ranges::all_of(words, isNumber)) break;
          type.parameters.push_back(parameter);
        }
        if (!type.parameters.empty()) types.push_back(std::move(type));
      }
  std::ranges::sort(types, {}, &TestDataType::id);
  return types;
}

/// Report E.2: sends up to ten numbers to a module, as which its first parameters are taken. What
/// is typed is kept for each id. Nothing is sent before the button is pressed.
class TestDataGenerator : public Dialog {
 public:
  explicit TestDataGenerator(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    id_ = makeControl<QComboBox>("id", "Task and solution; * marks those that run");
    QObject::connect(id_, &QComboBox::currentIndexChanged, this, [this] { showValues(); });
    layout->addWidget(id_);
    table_ = new QTableWidget{0, 3};
    table_->setObjectName("values");
    table_->setHorizontalHeaderLabels({"Name", "Value", "Unit"});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->verticalHeader()->hide();
    QObject::connect(table_, &QTableWidget::itemChanged, this, [this] { keep(); });
    layout->addWidget(table_);
    fault_ = new QLabel;
    fault_->setObjectName("fault");
    fault_->setWordWrap(true);
    layout->addWidget(fault_);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    addButton(*row, *this, "fromRobot", "From robot", "Takes the robot's values of now", [this] {
      typed_.remove(id());
      read();
    });
    addButton(*row, *this, "send", "Send", "Sends the numbers to the connected robots",
              [this] { send(); });
  }

  QJsonObject settings() const override { return {{"id", id()}, {"values", typed_}}; }
  void restore(const QJsonObject& settings) override {
    typed_ = settings["values"].toObject();
    wanted_ = settings["id"].toString();
    showTypes();
  }
  void refresh() override {
    const SessionStatus status = session().status();
    std::string connected;
    for (const RobotInfo& robot : status.robots)
      if (robot.selected && connected.empty()) connected = robot.name;
    if (status.beginnings == beginnings_ && connected == connected_) return;
    beginnings_ = status.beginnings;
    connected_ = connected;
    read();
  }

 private:
  QString id() const { return id_->currentData().toString(); }
  const TestDataType* chosen() const {
    const auto found = std::ranges::find(types_, id(), &TestDataType::id);
    return found == types_.end() ? nullptr : &*found;
  }

  void read() {
    session().ask(this, typesOf, [this](std::vector<TestDataType>& types) {
      types_ = std::move(types);
      showTypes();
    });
  }

  void showTypes() {
    const QString wanted = wanted_.isEmpty() ? id() : wanted_;
    {
      const QSignalBlocker quiet{id_};
      id_->clear();
      for (const TestDataType& type : types_)
        id_->addItem(type.id + (type.active ? " *" : ""), type.id);
      const int known = id_->findData(wanted);
      id_->setCurrentIndex(std::max(known, types_.empty() ? -1 : 0));
      if (known >= 0) wanted_.clear();
    }
    showValues();
  }

  /// What was typed last, or the robot's values.
  void showValues() {
    const QSignalBlocker quiet{table_};
    table_->setRowCount(0);
    fault_->clear();
    const TestDataType* const type = chosen();
    if (!type) return;
    const QJsonObject typed = typed_[type->id].toObject();
    for (const ParameterDescription& parameter : type->parameters) {
      const int row = table_->rowCount();
      table_->insertRow(row);
      const QString name = QString::fromStdString(parameter.path);
      const QString value = typed[name].toString(QString::fromStdString(parameter.value));
      QString help = QString::fromStdString(parameter.doc);
      if (parameter.low < parameter.high)
        help += QString{help.isEmpty() ? "%1 to %2" : " (%1 to %2)"}
                    .arg(parameter.low)
                    .arg(parameter.high);
      int column = 0;
      for (const QString& text : {name, value, QString::fromStdString(parameter.unit)}) {
        auto* item = new QTableWidgetItem{text};
        item->setToolTip(help);
        if (column != 1) item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        table_->setItem(row, column++, item);
      }
    }
  }

  void keep() {
    QJsonObject typed;
    for (int row = 0; row < table_->rowCount(); ++row)
      typed[table_->item(row, 0)->text()] = table_->item(row, 1)->text();
    typed_[id()] = typed;
  }

  void send() {
    const TestDataType* const type = chosen();
    if (!type) return;
    QString line = "sg " + type->id;
    for (int row = 0; row < table_->rowCount(); ++row)
      for (const QString& word : wordsOf(table_->item(row, 1)->text().toStdString())) {
        if (!isNumber(word)) {
          fault_->setText(table_->item(row, 0)->text() + ": " + word + " is no number");
          return;
        }
        line += word == "true" ? " 1" : word == "false" ? " 0" : " " + word;
      }
    session().execute(line.toStdString(), fault_, [this](const Result<void>& done) {
      fault_->setText(done ? "" : QString::fromStdString(done.error().text()));
    });
  }

  QComboBox* id_;
  QTableWidget* table_;
  QLabel* fault_;
  std::vector<TestDataType> types_;
  QJsonObject typed_;  ///< By ids: values by names.
  QString wanted_;     ///< Of a layout, until the robot's ids are known.
  std::string connected_;
  std::uint64_t beginnings_ = 0;
};

const RegisterDialog<TestDataGenerator> registeredTestDataGenerator{
    {.id = "testData",
     .title = "Test data generator",
     .group = "Robots",
     .help = "Sends up to ten numbers to a module, as which its first parameters are taken",
     .report = "E.2",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
