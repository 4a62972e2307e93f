#include <sys/resource.h>

#include <QElapsedTimer>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <csignal>
#include <filesystem>

#include "base/File.h"
#include "colors/ColorTableFile.h"
#include "logs/LogPlayer.h"
#include "workbench/SheetWidget.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// As long as it exists, no file grows beyond a size: the disk is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t size = 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{size, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

/// The window and its session end in the middle of something.
class ClosingTest : public WindowTest {
 protected:
  ClosingTest() : WindowTest{"scenes/one-robot.scene"} {
    answers_.setInterval(20);
    QObject::connect(&answers_, &QTimer::timeout,
                     [this] { QTimer::singleShot(0, &answers_, [this] { answer(); }); });
    answers_.start();
  }

  /// Closes the window, and answers what it asks by these buttons and files, one after another.
  bool close(const QStringList& answers) {
    wanted_ = answers;
    const bool closed = window->close();
    EXPECT_TRUE(wanted_.isEmpty()) << wanted_.join(", ").toStdString();
    return closed;
  }
  void answer() {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog || wanted_.isEmpty()) return;
    const QString wanted = wanted_.takeFirst();
    asked_ = dialog->windowTitle();
    if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
      asked_ = box->text();
      for (QAbstractButton* button : box->buttons())
        if (button->text().remove('&') == wanted) return QTest::mouseClick(button, Qt::LeftButton);
      return box->reject();
    }
    auto* line = dialog->findChild<QLineEdit*>();
    line->setText(wanted);
    QTest::keyClick(line, Qt::Key_Return);
  }
  QString path(const char* name) const { return settings() + "/" + name; }
  /// Ends all, and returns how long that takes in ms.
  qint64 end() {
    QElapsedTimer clock;
    clock.start();
    window.reset();
    session.reset();
    return clock.elapsed();
  }

  QTimer answers_;
  QStringList wanted_;
  QString asked_;
};

constexpr int soon = 60'000;  // ms; a run of 100 minutes takes longer

TEST_F(ClosingTest, ARunEnds) {
  session->execute("run 100 min");
  session->execute("run 100 min");
  EXPECT_TRUE(until([&] { return session->status().time.ms > 100; }));
  EXPECT_LT(end(), soon);
}

TEST_F(ClosingTest, AConnectionEnds) {
  session->execute("sc dog=tcp://127.0.0.1:1");  // nobody answers
  EXPECT_TRUE(until([&] { return printed("> sc dog"); }));
  EXPECT_LT(end(), soon);
}

TEST_F(ClosingTest, ARecordingIsAskedForAndSaved) {
  ASSERT_TRUE(execute("log start"));
  session->execute("start");
  EXPECT_TRUE(until([&] { return session->status().time.ms > 800; }));
  EXPECT_FALSE(close({"Cancel"}));
  EXPECT_TRUE(asked_.contains("the recording of red3")) << asked_.toStdString();
  // It went on meanwhile.
  const auto before = session->status().time;
  EXPECT_TRUE(until([&] { return session->status().time > before; }));
  EXPECT_TRUE(close({"Save", path("kept.mcap")}));
  const auto kept = LogPlayer::open(path("kept.mcap").toStdString());
  ASSERT_TRUE(kept) << kept.error().text();
  EXPECT_GT(kept->end() - kept->begin(), 500);
}

TEST_F(ClosingTest, ALayoutStaysWhenTheDiskIsFull) {
  window->open("radar");
  ASSERT_TRUE(window->saveLayout("mine"));
  const auto layout = readFile(path("mine.layout.json").toStdString());
  ASSERT_TRUE(layout);
  window->open("times");
  {
    const FullDisk full;
    EXPECT_FALSE(window->saveLayout("mine"));
    EXPECT_FALSE(close({"Save"}));
    EXPECT_TRUE(window->isVisible());
  }
  EXPECT_TRUE(*readFile(path("mine.layout.json").toStdString()) == *layout);
  EXPECT_TRUE(close({"Save"}));
  EXPECT_FALSE(*readFile(path("mine.layout.json").toStdString()) == *layout);
}

TEST_F(ClosingTest, ARecordingStaysWhenTheDiskIsFull) {
  ASSERT_TRUE(execute("log start"));
  ASSERT_TRUE(execute("run 400 ms"));
  ASSERT_TRUE(execute("log stop"));
  EXPECT_TRUE(until([&] { return !session->status().recordings.empty(); }));
  // A device that is always full.
  std::filesystem::create_symlink("/dev/full", path("full.mcap").toStdString());
  EXPECT_FALSE(close({"Save", path("full.mcap"), "Yes"}));
  EXPECT_TRUE(window->isVisible());
  EXPECT_TRUE(close({"Save", path("kept.mcap")}));
  EXPECT_TRUE(LogPlayer::open(path("kept.mcap").toStdString()));
}

TEST_F(ClosingTest, AColorTableStaysWhenTheDiskIsFull) {
  ASSERT_TRUE(execute("run 400 ms"));
  Dialog* const dialog = window->open("colorTable");
  auto* image = widget<SheetWidget>("colorTable", "image");
  EXPECT_TRUE(until([&] { return image->sheet() != nullptr; }));
  QTest::mouseClick(image, Qt::LeftButton, {}, image->rect().center());
  ASSERT_TRUE(dialog->unsaved());
  {
    const FullDisk full;
    EXPECT_FALSE(close({"Save", path("table.c64"), "OK"}));
    EXPECT_TRUE(asked_.contains("cannot be written")) << asked_.toStdString();
    EXPECT_TRUE(dialog->unsaved());
  }
  EXPECT_TRUE(close({"Save", path("table.c64")}));
  EXPECT_TRUE(readColorTable(path("table.c64").toStdString()));
}

TEST_F(ClosingTest, ARecordingThatFillsTheDiskIsToldAndKept) {
  ASSERT_TRUE(execute("log start"));
  ASSERT_TRUE(execute("run 1s"));
  constexpr rlim_t room = 500'000;
  {
    const FullDisk full{room};
    ASSERT_TRUE(execute("run 5s"));
  }
  ASSERT_TRUE(execute("log stop"));
  EXPECT_TRUE(until([&] { return !session->status().recordings.empty(); }));
  // What there is can be saved, and it is told that it is not all.
  const std::string file = path("kept.mcap").toStdString();
  const auto saved = execute("log save " + file);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text(), ::testing::HasSubstr("there was no room"));
  const auto kept = LogPlayer::open(file);
  ASSERT_TRUE(kept) << kept.error().text();
  EXPECT_GT(kept->messages(), 100u);
  EXPECT_TRUE(until([&] { return session->status().recordings.empty(); }));
}

TEST_F(ClosingTest, ABrokenLogIsRefusedInOneLine) {
  const std::string file = path("broken.mcap").toStdString();
  ASSERT_TRUE(writeFile(file, "no log"));
  const auto done = execute("sl recorded " + file);
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), ::testing::HasSubstr("broken.mcap"));
  EXPECT_EQ(done.error().text().find('\n'), std::string::npos);
  EXPECT_EQ(session->status().robots.size(), 1u);
  ASSERT_TRUE(execute("run 80 ms"));
}

}  // namespace
}  // namespace gt
