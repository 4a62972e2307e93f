#include "workbench/CommandPalette.h"

#include <QKeyEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>
#include <vector>

namespace gt {
namespace {

constexpr int mostShown = 30;

}  // namespace

int mismatch(const QString& letters, const QString& text) {
  int gaps = 0;
  qsizetype at = 0;
  for (const QChar letter : letters) {
    if (letter.isSpace()) continue;
    const qsizetype found = text.indexOf(letter, at, Qt::CaseInsensitive);
    if (found < 0) return -1;
    gaps += static_cast<int>(found - at);
    at = found + 1;
  }
  return gaps;
}

CommandPalette::CommandPalette(QWidget* parent, const QList<QAction*>& actions,
                               SessionThread& session)
    : QDialog{parent}, session_{session}, actions_{actions} {
  setWindowTitle("Find a command");
  setObjectName("palette");
  resize(560, 420);
  auto* layout = new QVBoxLayout{this};
  edit_ = new QLineEdit;
  edit_->setPlaceholderText("Some letters of a menu entry, or a line for the console");
  list_ = new QListWidget;
  layout->addWidget(edit_);
  layout->addWidget(list_);
  edit_->installEventFilter(this);
  QObject::connect(edit_, &QLineEdit::textChanged, this,
                   [this](const QString& text) { find(text); });
  QObject::connect(edit_, &QLineEdit::returnPressed, this, [this] { choose(); });
  QObject::connect(list_, &QListWidget::itemActivated, this, [this] { choose(); });
  find({});
}

void CommandPalette::find(const QString& letters) {
  std::vector<std::pair<int, QListWidgetItem*>> found;
  const auto add = [&](const QString& text, const QString& help, const QVariant& choice) {
    const int gaps = mismatch(letters, text);
    if (gaps < 0) return;
    auto* item = new QListWidgetItem{text};
    item->setToolTip(help);
    item->setData(Qt::UserRole, choice);
    found.emplace_back(gaps, item);
  };
  list_->clear();
  for (qsizetype i = 0; i < actions_.size(); ++i) {
    const QAction& action = *actions_[i];
    const QString keys = action.shortcut().toString();
    add(action.text().remove('&') + (keys.isEmpty() ? "" : "   " + keys), action.toolTip(), i);
  }
  // Once a command's name is typed, what follows is its arguments.
  const QString name = letters.section(' ', 0, 0);
  for (const Command& command : Console::commands()) {
    const QString known =
        QString::fromUtf8(command.name.data(), static_cast<qsizetype>(command.name.size()));
    const QString usage = QString::fromStdString(std::string{command.arguments});
    const QString help = QString::fromStdString(std::string{command.help});
    if (known == name) {
      auto* item = new QListWidgetItem{"> " + letters + "   (" + known + " " + usage + ")"};
      item->setToolTip(help);
      item->setData(Qt::UserRole, letters);
      found.emplace_back(-1, item);
    } else {
      add("> " + known + " " + usage, help, known + " ");
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<int, QListWidgetItem*>::first);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i < mostShown)
      list_->addItem(found[i].second);
    else
      delete found[i].second;
  }
  list_->setCurrentRow(0);
}

void CommandPalette::choose() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item) return;
  const QVariant choice = item->data(Qt::UserRole);
  if (choice.typeId() == QMetaType::QString) {
    // A command whose arguments are still missing is completed.
    const QString line = choice.toString();
    if (line.endsWith(' ')) return edit_->setText(line);
    session_.execute(line.toStdString());
    return accept();
  }
  QAction* action = actions_[choice.toLongLong()];
  accept();
  action->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (watched == edit_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Down || key == Qt::Key_Up) {
      const int row = list_->currentRow() + (key == Qt::Key_Down ? 1 : -1);
      list_->setCurrentRow(std::clamp(row, 0, list_->count() - 1));
      return true;
    }
  }
  return QDialog::eventFilter(watched, event);
}

}  // namespace gt
