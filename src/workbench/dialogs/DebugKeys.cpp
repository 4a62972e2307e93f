#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QGridLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "base/Lines.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

struct Mode {
  const char* name;
  const char* text;
  const char* help;
  const char* command;  ///< Of dk; %1 is n.
};
constexpr Mode modes[] = {{"off", "Off", "Never", "off"},
                          {"always", "Always", "Each time", "on"},
                          {"times", "n times", "The next n times", "%1"},
                          {"every", "Every n", "Every n-th time", "every %1"},
                          {"everyMs", "Every n ms", "Every n ms", "every %1 ms"}};
struct Fill {
  const char* text;
  const char* command;  ///< Of qfr; %1 is n.
};
constexpr Fill fills[] = {{"at once", "queue"},
                          {"in real time", "replace"},
                          {"after n s", "collect %1"},
                          {"to the stick for n s", "save %1"},
                          {"never", "reject"}};

constexpr const char* robotKinds[] = {"Simulated", "Physical"};

/// Report J.2.1: debug keys of physical and of simulated robots. Nothing is sent before the button
/// Send is pressed.
class DebugKeys : public Dialog {
 public:
  explicit DebugKeys(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* top = new QHBoxLayout;
    group_ = new QButtonGroup{this};
    for (int kind = 0; kind < 2; ++kind) {
      auto* button = makeControl<QToolButton>(QString{robotKinds[kind]}.toLower(),
                                              "Edits the table of these robots");
      button->setText(robotKinds[kind]);
      button->setCheckable(true);
      button->setChecked(kind == 0);
      group_->addButton(button, kind);
      top->addWidget(button);
    }
    QObject::connect(group_, &QButtonGroup::idClicked, this, [this](int kind) {
      kind_ = kind;
      showTable();
    });
    all_ = makeControl<QCheckBox>("all", "To all robots, not to the connected ones only", "All");
    top->addWidget(all_);
    top->addStretch();
    layout->addLayout(top);

    key_ = makeControl<QComboBox>("key", "A debug key, or send and the name of a representation");
    key_->setEditable(true);
    key_->setInsertPolicy(QComboBox::NoInsert);
    key_->completer()->setCompletionMode(QCompleter::PopupCompletion);
    key_->completer()->setFilterMode(Qt::MatchContains);
    layout->addWidget(key_);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    for (const Mode& mode : modes) {
      auto* button = makeControl<QToolButton>(mode.name, mode.help);
      button->setText(mode.text);
      QObject::connect(button, &QToolButton::clicked, this, [this, &mode] { set(mode); });
      buttons->addWidget(button);
    }
    n_ = makeControl<QSpinBox>("n", "The number n of the buttons before it: times or milliseconds");
    n_->setRange(1, 1'000'000);
    n_->setPrefix("n = ");
    buttons->addWidget(n_);
    buttons->addStretch();
    layout->addLayout(buttons);

    table_ = new QTableWidget{0, 3};
    table_->setObjectName("table");
    table_->setHorizontalHeaderLabels({"Key", "When", "Sent"});
    table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    QObject::connect(table_, &QTableWidget::cellClicked, this,
                     [this](int row, int) { key_->setEditText(table_->item(row, 0)->text()); });
    layout->addWidget(table_);

    auto* queue = new QHBoxLayout;
    queue->addWidget(new QLabel{"Send"});
    fill_ =
        makeControl<QComboBox>("fill", "How the robot's queue of messages to the tools is filled");
    for (const Fill& fill : fills) fill_->addItem(fill.text, fill.command);
    queue->addWidget(fill_, 1);
    seconds_ = makeControl<QSpinBox>("seconds", "The number n of the queue's modes: seconds");
    seconds_->setRange(1, 3600);
    seconds_->setValue(10);
    seconds_->setPrefix("n = ");
    queue->addWidget(seconds_);
    layout->addLayout(queue);

    auto* bottom = new QHBoxLayout;
    auto* off = makeControl<QPushButton>(
        "disableAll", "Takes all keys out of the table; Send switches them off", "Disable all");
    QObject::connect(off, &QPushButton::clicked, this, [this] {
      for (auto& [key, entry] : tables_[kind_]) entry = {};
      showTable();
    });
    auto* send = makeControl<QPushButton>("send", "Sends what has changed in both tables", "Send");
    QObject::connect(send, &QPushButton::clicked, this, [this] { sendAll(); });
    bottom->addWidget(off);
    bottom->addStretch();
    bottom->addWidget(send);
    layout->addLayout(bottom);
  }

  QJsonObject settings() const override {
    QJsonObject tables;
    for (int kind = 0; kind < 2; ++kind) {
      QJsonArray rows;
      for (const auto& [key, entry] : tables_[kind])
        if (entry.mode > 0) rows.append(QJsonArray{key, entry.mode, entry.n});
      tables[robotKinds[kind]] = rows;
    }
    return {{"tables", tables}, {"all", all_->isChecked()}};
  }
  void restore(const QJsonObject& settings) override {
    for (int kind = 0; kind < 2; ++kind) {
      tables_[kind].clear();
      for (const QJsonValue row : settings["tables"][robotKinds[kind]].toArray()) {
        const int mode = row[1].toInt();
        if (mode > 0 && mode < static_cast<int>(std::size(modes)))
          tables_[kind][row[0].toString()] = {mode, std::max(1, row[2].toInt())};
      }
    }
    all_->setChecked(settings["all"].toBool());
    showTable();
  }
  /// Shows the table of the connected robot's kind. A robot that began anew has all its keys off.
  void refresh() override {
    const SessionStatus status = session().status();
    const auto connected = std::ranges::find_if(status.robots, &RobotInfo::selected);
    if (connected != status.robots.end() && connected->name != connected_) {
      connected_ = connected->name;
      group_->button(connected->kind == RobotKind::physical ? 1 : 0)->click();
      offerKeys();
    }
    if (status.beginnings == beginnings_) return;
    beginnings_ = status.beginnings;
    offerKeys();
    for (auto& table : tables_)
      for (auto& [key, entry] : table) entry.sent = Sent::no;
    filled_.clear();
    showTable();
  }

 private:
  enum class Sent { no, yes, refused };
  struct Entry {
    int mode = 0;
    int n = 1;
    Sent sent = Sent::no;
    QString why{};  ///< It was refused.
  };

  /// Offers the keys of the connected robot, which may be another program.
  void offerKeys() {
    session().ask(
        this,
        [](Console& console) -> std::vector<std::string> {
          const auto robot = console.firstRobot();
          return robot ? (*robot)->observed().debugKeys() : std::vector<std::string>{};
        },
        [this](const std::vector<std::string>& keys) {
          if (keys == offered_) return;
          offered_ = keys;
          const QString typed = key_->currentText();
          key_->clear();
          for (const std::string& key : keys) key_->addItem(QString::fromStdString(key));
          key_->setEditText(typed);
        });
  }

  void set(const Mode& mode) {
    const QString key = key_->currentText().trimmed();
    if (key.isEmpty()) return;
    tables_[kind_][key] = {static_cast<int>(&mode - modes), n_->value()};
    showTable();
  }

  void showTable() {
    table_->setRowCount(0);
    for (const auto& [key, entry] : tables_[kind_]) {
      const int row = table_->rowCount();
      table_->insertRow(row);
      const QString when =
          QString{modes[entry.mode].text}.replace(" n", " " + QString::number(entry.n));
      table_->setItem(row, 0, new QTableWidgetItem{key});
      table_->setItem(
          row, 1, new QTableWidgetItem{entry.mode == 2 ? QString{"%1 times"}.arg(entry.n) : when});
      constexpr const char* sent[] = {"not yet", "yes", "refused"};
      auto* item = new QTableWidgetItem{sent[static_cast<int>(entry.sent)]};
      item->setToolTip(entry.why);
      table_->setItem(row, 2, item);
    }
  }

  void sendAll() {
    for (int kind = 0; kind < 2; ++kind) {
      const std::string queue =
          std::string{"to "} + (all_->isChecked() ? "all" : "") +
          (kind == 0 ? (all_->isChecked() ? "SimulatedRobots" : "simulatedRobot")
                     : (all_->isChecked() ? "PhysicalRobots" : "physicalRobot"));
      for (const auto& [key, entry] : tables_[kind]) {
        if (entry.sent == Sent::yes) continue;
        const QString when =
            QString{modes[entry.mode].command}.replace("%1", QString::number(entry.n));
        session().execute(
            queue + " dk " + quotedWord(key.toStdString()) + " " + when.toStdString(), this,
            [this, kind, key, entry](const Result<void>& done) { note(kind, key, entry, done); });
      }
    }
    const std::string fill = fill_->currentData()
                                 .toString()
                                 .replace("%1", QString::number(seconds_->value()))
                                 .toStdString();
    if (fill != filled_ && !(filled_.empty() && fill == "queue"))
      session().execute("qfr " + fill, this, [this, fill](const Result<void>& done) {
        if (done) filled_ = fill;
      });
    showTable();
  }

  /// Notes the result of sending an entry, if the entry is still the same. An entry that is off is
  /// no longer listed.
  void note(int kind, const QString& key, const Entry& sent, const Result<void>& done) {
    const auto entry = tables_[kind].find(key);
    if (entry == tables_[kind].end() || entry->second.mode != sent.mode ||
        entry->second.n != sent.n)
      return;
    entry->second.sent = done ? Sent::yes : Sent::refused;
    entry->second.why = done ? QString{} : QString::fromStdString(done.error().text());
    if (done && sent.mode == 0) tables_[kind].erase(entry);
    showTable();
  }

  QButtonGroup* group_;
  QCheckBox* all_;
  QComboBox* key_;
  std::vector<std::string> offered_;
  QSpinBox* n_;
  QTableWidget* table_;
  QComboBox* fill_;
  QSpinBox* seconds_;
  std::map<QString, Entry> tables_[2];  ///< Of simulated and of physical robots.
  int kind_ = 0;
  std::string filled_;
  std::string connected_;  ///< A robot.
  std::uint64_t beginnings_ = 0;
};

const RegisterDialog<DebugKeys> registeredDebugKeys{
    {.id = "debugKeys",
     .title = "Debug keys",
     .group = "Robots",
     .help =
         "What modules draw, plot and send, and how often; how the queue to the tools is filled",
     .report = "J.2.1",
     .place = DialogPlace::left,
     .atFirst = true}};

}  // namespace
}  // namespace gt
