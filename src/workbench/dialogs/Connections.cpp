#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QJsonArray>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "workbench/Dialog.h"

namespace gt {
namespace {

/// Report J.2.5: networks of robots elsewhere. A network has a name and lists robots, each enabled
/// or not; connecting starts a router to all that are enabled.
class Connections : public Dialog {
 public:
  explicit Connections(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* top = new QHBoxLayout;
    layout->addLayout(top);
    network_ = new QComboBox;
    network_->setObjectName("network");
    network_->setToolTip("The network's configuration");
    top->addWidget(network_, 1);
    button(*top, "new", "New…", "Adds a network",
           [this] { add(QInputDialog::getText(this, "New network", "Name:")); });
    button(*top, "delete", "Delete", "Deletes the network", [this] {
      networks_.remove(network_->currentText());
      showNetworks({});
    });
    table_ = new QTableWidget{0, 3};
    table_->setObjectName("robots");
    table_->setHorizontalHeaderLabels({"Enabled", "Name", "Address or endpoint"});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->verticalHeader()->hide();
    layout->addWidget(table_);
    auto* bottom = new QHBoxLayout;
    layout->addLayout(bottom);
    button(*bottom, "addRobot", "Add robot", "Adds a robot to the network", [this] {
      addRobot(true, "robot", "tcp://10.0.1.1:15000");
      keep();
    });
    button(*bottom, "removeRobot", "Remove robot", "Removes the robot that is marked", [this] {
      table_->removeRow(table_->currentRow());
      keep();
    });
    gameManager_ = new QCheckBox{"Game manager"};
    gameManager_->setObjectName("gameManager");
    gameManager_->setToolTip("The router has a port for a game manager, too");
    bottom->addWidget(gameManager_);
    bottom->addStretch();
    button(*bottom, "connect", "Connect", "Connects to all enabled robots", [this] { connect(); });
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
    QStringList elsewhere;
    for (const RobotInfo& robot : session().status().robots)
      if (robot.kind == RobotKind::physical) elsewhere << QString::fromStdString(robot.name);
    state_->setText(elsewhere.isEmpty()
                        ? "No robot elsewhere is connected."
                        : "Connected: " + elsewhere.join(", ") + ". A reset ends the connections.");
  }
  /// Adds a network without robots.
  void add(const QString& name) {
    if (name.trimmed().isEmpty() || networks_.contains(name)) return;
    networks_[name] = QJsonArray{};
    showNetworks(name);
  }

 private:
  template <typename Pressed>
  void button(QHBoxLayout& row, const char* name, const char* text, const char* help,
              Pressed pressed) {
    auto* made = new QPushButton{text};
    made->setObjectName(name);
    made->setToolTip(help);
    QObject::connect(made, &QPushButton::clicked, this, pressed);
    row.addWidget(made);
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
    for (const QJsonValue robot : networks_.value(name).toArray())
      addRobot(robot[0].toBool(), robot[1].toString(), robot[2].toString());
  }

  void addRobot(bool enabled, const QString& name, const QString& address) {
    const QSignalBlocker quiet{table_};
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* box = new QTableWidgetItem;
    box->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    box->setCheckState(enabled ? Qt::Checked : Qt::Unchecked);
    table_->setItem(row, 0, box);
    table_->setItem(row, 1, new QTableWidgetItem{name});
    table_->setItem(row, 2, new QTableWidgetItem{address});
  }

  bool enabled(int row) const { return table_->item(row, 0)->checkState() == Qt::Checked; }
  QString text(int row, int column) const { return table_->item(row, column)->text().trimmed(); }

  void keep() {
    if (network_->currentText().isEmpty()) return;
    QJsonArray robots;
    for (int row = 0; row < table_->rowCount(); ++row)
      robots.append(QJsonArray{enabled(row), text(row, 1), text(row, 2)});
    networks_[network_->currentText()] = robots;
  }

  void connect() {
    std::string line = gameManager_->isChecked() ? "sc gameManager" : "sc";
    bool any = false;
    for (int row = 0; row < table_->rowCount(); ++row)
      if (enabled(row)) {
        any = true;
        line += " " + text(row, 1).toStdString() + "=" + text(row, 2).toStdString();
      }
    if (any)
      session().execute(line);
    else
      state_->setText("No robot is enabled.");
  }

  QComboBox* network_;
  QTableWidget* table_;
  QCheckBox* gameManager_;
  QLabel* state_;
  QJsonObject networks_;  ///< By their names: robots as [enabled, name, endpoint].
};

const RegisterDialog<Connections> registered{
    {.id = "connections",
     .title = "Connections",
     .group = "Session",
     .help = "Networks of robots elsewhere, and connecting to them through a router",
     .report = "J.2.5",
     .place = DialogPlace::left}};

}  // namespace
}  // namespace gt
