#include <QAbstractItemView>
#include <QCompleter>
#include <QJsonArray>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QStringListModel>
#include <QVBoxLayout>

#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr int mostShownLines = 5000;
constexpr qsizetype mostRemembered = 200;

/// A word as it must be typed.
QString quoted(const QString& word) {
  return word.contains(' ') ? "\"" + word + "\"" : word;
}

/// Where the last word of a line begins.
qsizetype lastWord(const QString& line) {
  return line.lastIndexOf(' ') + 1;
}

/// Report I.5: the console. What is typed is completed while one types, or by the tab key.
class ConsoleDialog : public Dialog {
 public:
  explicit ConsoleDialog(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    output_ = new QPlainTextEdit;
    output_->setObjectName("output");
    output_->setReadOnly(true);
    output_->setMaximumBlockCount(mostShownLines);
    QFont font{"DejaVu Sans Mono"};
    font.setStyleHint(QFont::Monospace);
    output_->setFont(font);
    input_ = makeControl<QLineEdit>(
        "input", "A command of the console; up and down bring earlier ones back");
    input_->setFont(font);
    input_->setPlaceholderText("A command; help lists them, tab completes");
    help_ = new QLabel;
    help_->setObjectName("help");
    help_->setWordWrap(true);
    help_->setForegroundRole(QPalette::PlaceholderText);
    help_->hide();
    layout->addWidget(output_);
    layout->addWidget(help_);
    layout->addWidget(input_);
    completer_.setModel(&words_);
    completer_.setWidget(input_);
    completer_.setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    QObject::connect(&completer_, qOverload<const QString&>(&QCompleter::activated), this,
                     [this](const QString& word) { complete(word, true); });
    QObject::connect(input_, &QLineEdit::textEdited, this, [this](const QString& line) {
      showHelp(line);
      suggest(line, false);
    });
    QObject::connect(input_, &QLineEdit::returnPressed, this, [this] { execute(); });
    input_->installEventFilter(this);
    setFocusProxy(input_);
  }

  QJsonObject settings() const override {
    return {{"history", QJsonArray::fromStringList(history_)}};
  }
  void restore(const QJsonObject& settings) override {
    history_.clear();
    for (const QJsonValue line : settings["history"].toArray()) history_ << line.toString();
    place_ = history_.size();
  }
  void refresh() override {
    for (const std::string& line : session().linesSince(seen_)) {
      if (line == "\f")
        output_->clear();
      else
        output_->appendPlainText(QString::fromStdString(line));
    }
    for (const std::string& line : session().takeOffers())
      history_.insert(0, QString::fromStdString(line));
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched != input_ || event->type() != QEvent::KeyPress)
      return Dialog::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Tab) {
      suggest(input_->text(), true);
      return true;
    }
    if (key == Qt::Key_Up || key == Qt::Key_Down) {
      remember(key == Qt::Key_Up ? -1 : 1);
      return true;
    }
    return false;
  }

 private:
  void execute() {
    completer_.popup()->hide();
    const QString line = input_->text().trimmed();
    if (line.isEmpty()) return;
    history_.removeAll(line);
    history_ << line;
    if (history_.size() > mostRemembered) history_.removeFirst();
    place_ = history_.size();
    input_->clear();
    help_->hide();
    session().execute(line.toStdString());
  }

  /// Goes through the lines that were typed.
  void remember(int by) {
    const qsizetype place = place_ + by;
    if (place < 0 || place > history_.size()) return;
    place_ = place;
    input_->setText(place < history_.size() ? history_[place] : QString{});
    showHelp(input_->text());
  }

  /// Shows what may follow; with the tab key, the beginning that all have is typed.
  void suggest(const QString& line, bool tab) {
    if (line.isEmpty() && !tab) return completer_.popup()->hide();
    session().ask(
        this, [text = line.toStdString()](Console& console) { return console.completions(text); },
        [this, line, tab](const std::vector<std::string>& found) {
          if (line != input_->text()) return;  // something else was typed meanwhile
          QStringList words;
          for (const std::string& word : found) words << QString::fromStdString(word);
          words_.setStringList(words);
          const bool known = words.isEmpty() || words == QStringList{line.mid(lastWord(line))};
          if (tab && words.size() == 1) return complete(words.front(), true);
          if (known) return completer_.popup()->hide();
          if (tab) {
            QString common = words.front();
            for (const QString& word : words)
              while (!word.startsWith(common)) common.chop(1);
            if (common.size() > line.size() - lastWord(line)) complete(common, false);
          }
          completer_.complete();
        });
  }

  /// Replaces the last word of the line.
  void complete(const QString& word, bool whole) {
    const QString line = input_->text();
    const bool folder = word.endsWith('/');
    input_->setText(line.left(lastWord(line)) + quoted(word) + (whole && !folder ? " " : ""));
    showHelp(input_->text());
  }

  /// Shows how the command is used whose name was typed.
  void showHelp(const QString& line) {
    const Command* command = Console::find(line.section(' ', 0, 0).toStdString());
    help_->setVisible(command != nullptr);
    if (command)
      help_->setText(QString::fromStdString(std::string{command->name} + " " +
                                            std::string{command->arguments} + "\n" +
                                            std::string{command->help}));
  }

  QPlainTextEdit* output_;
  QLabel* help_;
  QLineEdit* input_;
  QStringListModel words_;
  QCompleter completer_;
  QStringList history_;
  qsizetype place_ = 0;
  std::uint64_t seen_ = 0;
};

const RegisterDialog<ConsoleDialog> registeredConsoleDialog{
    {.id = "console",
     .title = "Console",
     .group = "Session",
     .help = "All commands, typed; what they and the robots print",
     .report = "I.5",
     .place = DialogPlace::bottom,
     .atFirst = true}};

}  // namespace
}  // namespace gt
