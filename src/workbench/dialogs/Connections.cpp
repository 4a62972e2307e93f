#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QJsonArray>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "representations/infrastructure/Player.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

enum Column {
  enabledColumn,
  nameColumn,
  addressColumn,
  teamColumn,
  roleColumn,
  targetColumn,
  copyColumn,
  columns
};

/// Report J.2.5: networks of robots elsewhere. A network has a name and lists robots, each enabled
/// or not; connecting starts a router to all that are enabled. The configuration is copied to each
/// robot with what stands here, so that both are the same.
class Connections : public Dialog {
 public:
  explicit Connections(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* top = new QHBoxLayout;
    layout->addLayout(top);
    network_ = makeControl<QComboBox>("network", "The network's configuration");
    top->addWidget(network_, 1);
    addButton(*top, *this, "new", "New…", "Adds a network",
              [this] { add(QInputDialog::getText(this, "New network", "Name:")); });
    addButton(*top, *this, "delete", "Delete", "Deletes the network", [this] {
      networks_.remove(network_->currentText());
      showNetworks({});
    });
    table_ = new QTableWidget{0, columns};
    table_->setObjectName("robots");
    table_->setHorizontalHeaderLabels(
        {"Enabled", "Name", "Address or endpoint", "Team", "Role", "Configuration at", ""});
    table_->horizontalHeaderItem(targetColumn)
        ->setToolTip("A folder, such as a memory stick, or HOST:FOLDER by ssh");
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->verticalHeader()->hide();
    layout->addWidget(table_);
    auto* bottom = new QHBoxLayout;
    layout->addLayout(bottom);
    addButton(*bottom, *this, "addRobot", "Add robot", "Adds a robot to the network", [this] {
      addRobot({true, "robot", "tcp://10.0.1.1:15000"});
      keep();
    });
    addButton(*bottom, *this, "removeRobot", "Remove robot", "Removes the robot that is marked",
              [this] {
                table_->removeRow(table_->currentRow());
                keep();
              });
    gameManager_ = makeControl<QCheckBox>(
        "gameManager", "The router has a port for a game manager, too", "Game manager");
    bottom->addWidget(gameManager_);
    bottom->addStretch();
    addButton(*bottom, *this, "connect", "Connect", "Connects to all enabled robots",
              [this] { connect(); });
    state_ = new QLabel;
    state_->setObjectName("state");
    state_->setWordWrap(true);
    layout->addWidget(state_);
    QObject::connect(network_, &QComboBox::currentTextChanged, this,
                     [this](const QString& name) { showRobots(name); });
    QObject::connect(table_, &QTableWidget::itemChanged, this, [this] { keep(); });
  }

  QJsonObject settings() const override {
    return {{"networks", networks_}, {"current", network_->currentText()}};
  }
  void restore(const QJsonObject& settings) override {
    networks_ = settings["networks"].toObject();
    showNetworks(settings["current"].toString());
  }
  void refresh() override {
    constexpr int interval = 1000;  // ms
    if (asked_ || (clock_.isValid() && clock_.elapsed() < interval)) return;
    asked_ = true;
    session().ask(
        this, [](Console& console) { return console.session().connections(); },
        [this](std::vector<Router::Statistics>& now) { showState(now); });
  }
  /// Adds a network without robots.
  void add(const QString& name) {
    if (name.trimmed().isEmpty() || networks_.contains(name)) return;
    networks_[name] = QJsonArray{};
    showNetworks(name);
  }

 private:
  /// Shows a line for each robot that was connected to, with rates since the time before.
  void showState(std::vector<Router::Statistics>& now) {
    constexpr double perSecond = 1000;  // ms
    const double seconds = clock_.isValid() ? static_cast<double>(clock_.elapsed()) / perSecond : 0;
    clock_.start();
    asked_ = false;
    QStringList lines = note_;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const Router::Statistics& robot = now[i];
      QString line = QString::fromStdString(robot.robot) +
                     (robot.connected ? ": connected" : ": does not answer");
      if (!robot.trouble.empty()) line += ", " + QString::fromStdString(robot.trouble);
      if (i < before_.size() && before_[i].robot == robot.robot && seconds > 0) {
        const auto rate = [&](std::uint64_t Router::Statistics::*count) {
          return QString::number(static_cast<double>(robot.*count - before_[i].*count) / seconds,
                                 'f', 0);
        };
        line += ", " + rate(&Router::Statistics::toTools) + " messages/s from it, " +
                rate(&Router::Statistics::toRobot) + " to it";
      }
      if (robot.dropped > 0) line += QString{", %1 dropped"}.arg(robot.dropped);
      if (robot.rejected > 0) line += QString{", %1 rejected"}.arg(robot.rejected);
      lines << line;
    }
    lines << (now.empty() ? "No robot elsewhere is connected." : "A reset ends the connections.");
    before_ = std::move(now);
    state_->setText(lines.join("\n"));
  }
  /// Shows why something could not be done, until something else is.
  void note(const QString& text) {
    note_ = {text};
    clock_.invalidate();
  }

  void showNetworks(const QString& current) {
    {
      const QSignalBlocker quiet{network_};
      network_->clear();
      network_->addItems(networks_.keys());
      network_->setCurrentIndex(network_->findText(current));
      if (network_->currentIndex() < 0 && network_->count() > 0) network_->setCurrentIndex(0);
    }
    showRobots(network_->currentText());
  }

  void showRobots(const QString& name) {
    {
      const QSignalBlocker quiet{table_};
      table_->setRowCount(0);
    }
    for (const QJsonValue robot : networks_.value(name).toArray()) addRobot(robot.toArray());
  }

  /// Adds a robot as networks_ keeps it.
  void addRobot(const QJsonArray& robot) {
    const QSignalBlocker quiet{table_};
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* box = new QTableWidgetItem;
    box->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    box->setCheckState(robot[0].toBool() ? Qt::Checked : Qt::Unchecked);
    table_->setItem(row, enabledColumn, box);
    for (const int column : {nameColumn, addressColumn, targetColumn})
      table_->setItem(row, column, new QTableWidgetItem{robot[column].toString()});
    addChoice<TeamColor>(row, teamColumn, robot[teamColumn].toString());
    addChoice<PlayerRole>(row, roleColumn, robot[roleColumn].toString());
    auto* copy = makeControl<QPushButton>(
        "copy", "Copies the configuration with this name, address, team color and role", "Copy");
    QObject::connect(copy, &QPushButton::clicked, this, [this, copy] { deploy(rowOf(copy)); });
    table_->setCellWidget(row, copyColumn, copy);
  }
  template <typename E>
  void addChoice(int row, int column, const QString& chosen) {
    auto* choice = new QComboBox;
    for (const std::string_view name : enumNames<E>)
      choice->addItem(QString::fromStdString(std::string{name}));
    choice->setCurrentIndex(std::max(0, choice->findText(chosen)));
    QObject::connect(choice, &QComboBox::currentTextChanged, this, [this] { keep(); });
    table_->setCellWidget(row, column, choice);
  }

  int rowOf(const QWidget* button) const {
    int row = table_->rowCount() - 1;
    while (row >= 0 && table_->cellWidget(row, copyColumn) != button) --row;
    return row;
  }
  bool enabled(int row) const {
    return table_->item(row, enabledColumn)->checkState() == Qt::Checked;
  }
  QString text(int row, int column) const {
    if (const auto* choice = qobject_cast<QComboBox*>(table_->cellWidget(row, column)))
      return choice->currentText();
    return table_->item(row, column)->text().trimmed();
  }

  void keep() {
    if (network_->currentText().isEmpty()) return;
    QJsonArray robots;
    for (int row = 0; row < table_->rowCount(); ++row) {
      QJsonArray robot{enabled(row)};
      for (int column = nameColumn; column < copyColumn; ++column) robot.append(text(row, column));
      robots.append(robot);
    }
    networks_[network_->currentText()] = robots;
  }

  /// Tools connect at the robot's port of all its addresses.
  void deploy(int row) {
    if (row < 0) return;  // of a button that is about to be deleted
    if (text(row, targetColumn).isEmpty()) {
      note("Where the robot's configuration lies is not known.");
      return;
    }
    QString line = "deploy";
    for (const int column : {nameColumn, teamColumn, roleColumn, targetColumn})
      line += " \"" + text(row, column) + "\"";
    const QString port = text(row, addressColumn).section(':', 2);
    if (!port.isEmpty()) line += " tcp://0.0.0.0:" + port;
    note_.clear();
    session().execute(line.toStdString());
  }

  void connect() {
    note_.clear();
    std::string line = gameManager_->isChecked() ? "sc gameManager" : "sc";
    bool any = false;
    for (int row = 0; row < table_->rowCount(); ++row)
      if (enabled(row)) {
        any = true;
        line += " " + text(row, nameColumn).toStdString() + "=" +
                text(row, addressColumn).toStdString();
      }
    if (any)
      session().execute(line);
    else
      note("No robot is enabled.");
  }

  QComboBox* network_;
  QTableWidget* table_;
  QCheckBox* gameManager_;
  QLabel* state_;
  QJsonObject networks_;                    ///< By their names: robots as their rows.
  std::vector<Router::Statistics> before_;  ///< A second ago, or so.
  QElapsedTimer clock_;                     ///< Since then.
  QStringList note_;
  bool asked_ = false;
};

const RegisterDialog<Connections> registeredConnections{
    {.id = "connections",
     .title = "Connections",
     .group = "Session",
     .help = "Networks of robots elsewhere, connecting to them through a router, and copying their "
             "configuration",
     .report = "J.2.5",
     .place = DialogPlace::bottom}};

}  // namespace
}  // namespace gt
