#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QJsonArray>
#include <QLabel>
#include <QListWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "logs/LogPlayer.h"
#include "logs/LogTransfer.h"
#include "workbench/Background.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

/// What is in a log.
struct LogContent {
  struct Topic {
    std::string name;
    std::uint64_t messages = 0;
  };
  std::vector<Topic> topics{};
  double begin = 0, end = 0;  ///< s
};

Result<LogContent> contentOf(const std::string& file) {
  const auto player = LogPlayer::open(file);
  if (!player) return player.error();
  LogContent content;
  content.begin = static_cast<double>(player->begin().ms) / 1000;
  content.end = static_cast<double>(player->end().ms) / 1000;
  for (const McapChannel& channel : player->log().channels())
    content.topics.push_back({channel.topic, player->messagesOf(channel.id)});
  return content;
}

/// Writes parts of a log, or several logs joined, as a new one.
class LogEditor : public Dialog {
 public:
  explicit LogEditor(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    logs_ = makeControl<QListWidget>(
        "logs", "One log to take parts of, or several that are joined by time");
    logs_->setMaximumHeight(80);
    row->addWidget(logs_, 1);
    auto* buttons = new QVBoxLayout;
    row->addLayout(buttons);
    addButton(*buttons, *this, "add", "Add…", "Adds a log", [this] {
      const QString file =
          QFileDialog::getOpenFileName(this, "Add a log", "out/logs", "Logs (*.mcap)");
      if (file.isEmpty()) return;
      logs_->addItem(file);
      look();
    });
    addButton(*buttons, *this, "remove", "Remove", "Takes the chosen log away", [this] {
      delete logs_->currentItem();
      look();
    });
    buttons->addStretch();
    auto* times = new QHBoxLayout;
    layout->addLayout(times);
    from_ = addTime(*times, "from", "From", "What was before is left out");
    to_ = addTime(*times, "to", "to", "What was from then on is left out");
    times->addStretch();
    topics_ = makeControl<QTreeWidget>("topics", "What is not marked is left out");
    topics_->setRootIsDecorated(false);
    topics_->setHeaderLabels({"Messages of", "Number"});
    topics_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    topics_->header()->setStretchLastSection(false);
    layout->addWidget(topics_, 1);
    auto* bottom = new QHBoxLayout;
    layout->addLayout(bottom);
    addButton(*bottom, *this, "write", "Write as…", "Writes what is chosen as a new log",
              [this] { write(); });
    state_ = new QLabel{"Add a log"};
    state_->setObjectName("state");
    state_->setWordWrap(true);
    bottom->addWidget(state_, 1);
  }

  QJsonObject settings() const override {
    QJsonArray files;
    for (int i = 0; i < logs_->count(); ++i) files.append(logs_->item(i)->text());
    return {{"logs", files}};
  }
  void restore(const QJsonObject& settings) override {
    if (settings["logs"] == this->settings()["logs"]) return;
    logs_->clear();
    for (const QJsonValue file : settings["logs"].toArray()) logs_->addItem(file.toString());
    look();
  }
  void refresh() override {}

 private:
  QDoubleSpinBox* addTime(QHBoxLayout& row, const char* name, const char* label, const char* help) {
    row.addWidget(new QLabel{label});
    auto* made = makeControl<QDoubleSpinBox>(name, help);
    made->setDecimals(3);
    made->setRange(0, 1e6);
    made->setSuffix(" s");
    row.addWidget(made);
    return made;
  }

  std::vector<std::string> files() const {
    std::vector<std::string> files;
    for (int i = 0; i < logs_->count(); ++i) files.push_back(logs_->item(i)->text().toStdString());
    return files;
  }

  /// Lists what is in the log, if it is one.
  void look() {
    topics_->clear();
    const bool one = logs_->count() == 1;
    for (QWidget* part : std::initializer_list<QWidget*>{from_, to_, topics_})
      part->setEnabled(one);
    if (!one)
      return state_->setText(logs_->count() == 0 ? "Add a log" : "All of these logs are joined");
    state_->setText("Reading…");
    work_.start(
        this, [file = files().front()](const Background::Progress&) { return contentOf(file); },
        [this](const Result<LogContent>& content) { show(content); });
  }
  void show(const Result<LogContent>& content) {
    if (!content) return state_->setText(QString::fromStdString(content.error().text()));
    from_->setValue(content->begin);
    to_->setValue(content->end + 0.001);
    for (const LogContent::Topic& topic : content->topics) {
      auto* item = new QTreeWidgetItem{topics_};
      item->setText(0, QString::fromStdString(topic.name));
      item->setText(1, QString::number(topic.messages));
      item->setCheckState(0, Qt::Checked);
    }
    state_->setText(QString{"%1 to %2 s"}.arg(content->begin).arg(content->end));
  }

  void write() {
    if (logs_->count() == 0 || work_.running()) return;
    const QString file =
        QFileDialog::getSaveFileName(this, "Write a log", "out/logs/part.mcap", "Logs (*.mcap)");
    if (file.isEmpty()) return;
    Selection selection;
    selection.from = from_->value();
    selection.to = to_->value();
    for (int i = 0; i < topics_->topLevelItemCount(); ++i)
      if (topics_->topLevelItem(i)->checkState(0) != Qt::Checked)
        selection.without.push_back(topics_->topLevelItem(i)->text(0).toStdString());
    state_->setText("Writing…");
    work_.start(
        this,
        [logs = files(), selection, to = file.toStdString()](const Background::Progress&) {
          return logs.size() == 1 ? cutLog(logs.front(), selection, to) : joinLogs(logs, to);
        },
        [this, file](const Result<Transferred>& done) {
          if (!done) return state_->setText(QString::fromStdString(done.error().text()));
          QString text = QString{"%1: %2 messages"}.arg(file).arg(done->messages);
          for (const Error& lost : done->lost) text += "\n" + QString::fromStdString(lost.text());
          state_->setText(text);
        });
  }

  QListWidget* logs_;
  QDoubleSpinBox* from_;
  QDoubleSpinBox* to_;
  QTreeWidget* topics_;
  QLabel* state_;
  Background work_;
};

const RegisterDialog<LogEditor> registeredLogEditor{
    {.id = "logEditor",
     .title = "Edit logs",
     .group = "Session",
     .help = "Cuts a part or some messages out of a log, or joins several",
     .report = "J.2.4"}};

}  // namespace
}  // namespace gt
