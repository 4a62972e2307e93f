#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QTimer>
#include <QtTest>
#include <optional>
#include <stdexcept>

#include "base/TemporaryFolder.h"
#include "console/Values.h"
#include "workbench/MainWindow.h"

namespace gt {

/// A window on a scene of one or more robots, driven by its widgets. Tests check the effects in the
/// session and its robots, not in the widgets.
class WindowTest : public ::testing::Test {
 protected:
  explicit WindowTest(const std::string& scene = "scenes/match.scene",
                      const std::optional<Keys>& keys = {}) {
    qputenv("XDG_STATE_HOME", folder.path().c_str());
    const auto root = DataRoot::find(DataRoot::places(""));
    MatchOptions options{root ? *root : DataRoot{}};
    options.scene = options.root.path(scene);
    options.keys = keys;
    auto made = SessionThread::make(options);
    EXPECT_TRUE(made) << made.error().text();
    session = std::move(*made);
    window = std::make_unique<MainWindow>(*session, settings());
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }

  QString settings() const { return QString::fromStdString(folder.path().string()); }

  static constexpr int patience = 120'000;  // ms; machines may be loaded
  /// Handles the window's events until something holds.
  template <typename Condition>
  static bool until(Condition condition, int ms = patience) {
    return QTest::qWaitFor(condition, ms);
  }
  /// The result of `work` on the session's thread. Ends the test if there is no answer.
  template <typename Work>
  auto on(Work work) {
    std::optional<decltype(work(std::declval<Console&>()))> result;
    QObject receiver;
    session->ask(&receiver, std::move(work), [&](auto& answer) { result = std::move(answer); });
    if (!until([&] { return result.has_value(); }, patience))
      throw std::runtime_error{"no answer came"};
    return std::move(*result);
  }
  /// A value by its path, as the console's command get.
  std::string value(const std::string& path) {
    return on([path](Console& console) {
      const auto found = valueAt(console, path);
      return found ? found->text : "error: " + found.error().text();
    });
  }
  /// Executes a line and waits for its end. Ends the test if the line never ends.
  Result<void> execute(const std::string& line) {
    std::optional<Result<void>> result;
    QObject receiver;
    session->execute(line, &receiver, [&](const Result<void>& done) { result = done; });
    if (!until([&] { return result.has_value(); }, patience))
      throw std::runtime_error{line + " never ended"};
    return *result;
  }
  /// Waits until all commands were executed that were given so far.
  void finish() { EXPECT_TRUE(execute("# all is done")); }
  /// Answers the next file dialog with `file`, repeatedly until the dialog accepts it: at first it
  /// may not know its folder yet.
  void answerWith(const std::string& file) {
    answers_.disconnect();
    QObject::connect(&answers_, &QTimer::timeout, [this, file] {
      auto* chooser = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!chooser) return;
      auto* field = chooser->findChild<QLineEdit*>();
      field->setText(QString::fromStdString(file));
      QTest::keyClick(field, Qt::Key_Return);
      if (!chooser->isVisible()) answers_.stop();
    });
    answers_.start(20);
  }
  bool printed(const std::string& text) {
    std::uint64_t seen = 0;
    for (const std::string& line : session->linesSince(seen))
      if (line.find(text) != line.npos) return true;
    return false;
  }

  template <typename Widget>
  Widget* widget(const QString& dialog, const QString& name) {
    Dialog* const parent = window->dialog(dialog);
    EXPECT_TRUE(parent) << dialog.toStdString();
    auto* found = parent ? parent->findChild<Widget*>(name) : nullptr;
    EXPECT_TRUE(found) << dialog.toStdString() << " " << name.toStdString();
    return found;
  }
  /// Clicks as soon as that is possible.
  void click(const QString& dialog, const QString& name) {
    auto* const target = widget<QWidget>(dialog, name);
    ASSERT_TRUE(until([&] { return target->isEnabled(); })) << name.toStdString();
    QTest::mouseClick(target, Qt::LeftButton);
  }
  /// Chooses an entry as a person does.
  void choose(const QString& dialog, const QString& name, const QString& entry) {
    auto* box = widget<QComboBox>(dialog, name);
    ASSERT_TRUE(until([&] { return box->findText(entry) >= 0; })) << entry.toStdString();
    const int index = box->findText(entry);
    box->setFocus();
    while (box->currentIndex() != index)
      QTest::keyClick(box, box->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
  }

  TemporaryFolder folder;
  std::unique_ptr<SessionThread> session;
  std::unique_ptr<MainWindow> window;

 private:
  QTimer answers_;
};

/// A window on a scene of one robot.
class DialogTest : public WindowTest {
 protected:
  DialogTest() : WindowTest{"scenes/one-robot.scene"} {}
};

}  // namespace gt
