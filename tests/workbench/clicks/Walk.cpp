#include "workbench/clicks/Walk.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QPixmap>
#include <QRegularExpression>
#include <QtTest>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "console/Condition.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr int longSettling = 1500;  // ms, until dialogs show what is new
constexpr int patience = 120;       // s; machines may be loaded

/// A copy of what programs read, in which pages may write.
void copyData(const fs::path& from, const fs::path& to) {
  for (const char* part : {"behavior", "config", "motions"})
    fs::copy(from / part, to / part, fs::copy_options::recursive);
  for (const char* part : {"layouts", "models", "scenes", "sounds", "teams"})
    fs::create_directory_symlink(fs::absolute(from / part), to / part);
}

}  // namespace

void savePicture(const QPixmap& picture, const QString& file) {
  QDir{}.mkpath(QFileInfo{file}.path());
  constexpr int best = 0;  // of PNG: the smallest file
  if (!picture.toImage().convertToFormat(QImage::Format_RGB888).save(file, "PNG", best))
    fail(file + " cannot be written");
}

Walk::~Walk() {
  hand_.reset();
  window_.reset();
  session_.reset();
}

template <typename Work>
auto Walk::on(Work work) {
  std::optional<decltype(work(std::declval<Console&>()))> result;
  QObject receiver;
  session_->ask(&receiver, std::move(work), [&](auto& answer) { result = std::move(answer); });
  waitUntil([&] { return result.has_value(); }, "the session does not answer", patience);
  return std::move(*result);
}

/// Waits until all commands were executed that buttons gave.
void Walk::finish() {
  bool done = false;
  QObject receiver;
  session_->execute("# done", &receiver, [&](const Result<void>&) { done = true; });
  waitUntil([&] { return done; }, "a command does not end", patience);
}

bool Walk::holds(const QString& text) {
  const auto condition = Condition::parse(text.toStdString());
  if (!condition) throw std::runtime_error{condition.error().text()};
  // What has not come yet does not hold yet.
  return on([&](Console& console) {
    const auto found = condition->holds(console);
    return found && *found;
  });
}

void Walk::begin(const QString& scene, const QString& seed) {
  hand_.reset();
  window_.reset();
  session_.reset();
  MatchOptions options{DataRoot{folder_.path().string()}};
  options.scene = options.root.path(scene.toStdString());
  options.seed = seed.toULongLong();
  auto made = SessionThread::make(options);
  if (!made) throw std::runtime_error{made.error().text()};
  session_ = std::move(*made);
  session_->executeQuietly("st on 1");
  session_->callStartScript();
  window_ = std::make_unique<MainWindow>(
      *session_, QString::fromStdString((folder_.path() / "settings").string()));
  window_->resize(1280, 720);
  window_->show();
  if (!QTest::qWaitForWindowExposed(window_.get())) fail("the window does not appear");
  QTest::qWait(longSettling);
  hand_ = std::make_unique<Hand>(*window_);
  clicks_ = texts_ = 0;
}

void Walk::show(const QString& name, const QString& title) {
  QWidget* shown = window_.get();
  if (!title.isEmpty()) shown = hand_->dialog(title).parentWidget();
  QTest::qWait(longSettling);
  if (!pictures_.empty())
    savePicture(shown->grab(), QString::fromStdString(pictures_) + "/" + name);
}

void Walk::perform(const QString& line) {
  struct Sentence {
    const char* pattern;
    std::function<void(const QStringList&)> perform;
  };
  const auto path = [](const QString& text) { return text.split(" > "); };
  const auto share = [](const QString& x, const QString& y) {
    constexpr double percent = 0.01;
    return percent * QPointF{x.toDouble(), y.toDouble()};
  };
  const auto pixel = [](const QString& x, const QString& y) {
    return QPoint{x.toInt(), y.toInt()};
  };
  const std::vector<Sentence> sentences{
      {"robotcontrol (\\S+) --seed (\\d+)", [&](auto& part) { begin(part[1], part[2]); }},
      {"open (.+)", [&](auto& part) { hand_->open(part[1]); }},
      {"menu (.+)", [&](auto& part) { hand_->chooseInMenuBar(path(part[1])); }},
      {"right-click (\\d+)% (\\d+)% of (?:(\\w+) in )?(.+?): (.+)",
       [&](auto& part) {
         hand_->chooseInContextMenu(path(part[5]), part[4], part[3], share(part[1], part[2]));
       }},
      {"click pixel (\\d+) (\\d+) of (\\w+) in (.+)",
       [&](auto& part) {
         hand_->clickPixel(pixel(part[1], part[2]), part[3], part[4], Qt::LeftButton);
       }},
      {"right-click pixel (\\d+) (\\d+) of (\\w+) in (.+)",
       [&](auto& part) {
         hand_->clickPixel(pixel(part[1], part[2]), part[3], part[4], Qt::RightButton);
       }},
      {"click (.+) in (.+)", [&](auto& part) { hand_->click(part[1], part[2]); }},
      {"choose (.+) for (.+) in (.+)",
       [&](auto& part) { hand_->choose(part[1], part[2], part[3]); }},
      {"type (.*) into (.+) in (.+)", [&](auto& part) { hand_->type(part[1], part[2], part[3]); }},
      {"expand (.+) in (.+)", [&](auto& part) { hand_->expand(part[1], part[2]); }},
      {"change (.+) to (.+) in (.+)", [&](auto& part) { hand_->edit(part[1], part[2], part[3]); }},
      {"drag (\\d+)% (\\d+)% to (\\d+)% (\\d+)% of (?:(\\w+) in )?(.+)",
       [&](auto& part) {
         hand_->drag(share(part[1], part[2]), share(part[3], part[4]), part[5], part[6]);
       }},
      {"until (.+)",
       [&](auto& part) {
         waitUntil([&] { return holds(part[1]); }, part[1] + " does not come true", patience);
       }},
      {"expect file (.+)",
       [&](auto& part) {
         finish();
         if (!QFile::exists(part[1])) fail("there is no file " + part[1]);
       }},
      {"expect drawing (\\S+)",
       [&](auto& part) {
         waitUntil(
             [&] {
               return on([key = part[1].toStdString()](Console& console) {
                 const auto first = console.firstRobot();
                 return first && (*first)->observed().drawings().contains(key);
               });
             },
             "the robot draws no " + part[1]);
       }},
      {"expect (.+)",
       [&](auto& part) {
         finish();
         if (on([](Console& console) { return console.session().started(); }))
           fail("time passes, so that only \"until\" can tell");
         if (!holds(part[1])) fail(part[1] + " does not hold");
       }},
      {"read (.+) in (.+)",
       [&](auto& part) {
         waitUntil(
             [&] { return hand_->texts(part[2]).join('\n').contains(QRegularExpression{part[1]}); },
             part[2] + " does not say that, but: " + hand_->texts(part[2]).join(" | "));
       }},
      {"given (.+)",
       [&](auto& part) {
         session_->execute(part[1].toStdString());
         finish();
       }},
      {"picture (\\S+)(?: of (.+))?", [&](auto& part) { show(part[1], part[2]); }},
      {"(\\d+) clicks?(?:, (\\d+) texts?)?", [&](auto& part) {
         const int clicks = hand_->clicks() - std::exchange(clicks_, hand_->clicks());
         const int texts = hand_->texts() - std::exchange(texts_, hand_->texts());
         if (clicks != part[1].toInt() || texts != part[2].toInt())
           fail(QString{"it took %1 clicks, %2 texts"}.arg(clicks).arg(texts));
       }}};
  for (const Sentence& known : sentences) {
    const auto match =
        QRegularExpression{QRegularExpression::anchoredPattern(known.pattern)}.match(line);
    if (!match.hasMatch()) continue;
    QStringList parts = match.capturedTexts();
    constexpr int most = 8;
    while (parts.size() < most) parts << QString{};
    known.perform(parts);
    return;
  }
  fail("no such sentence");
}

void Walk::read(const std::string& page) {
  QFile file{QString::fromStdString(page)};
  if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error{page + " cannot be read"};
  std::vector<Line> lines;
  bool inside = false;
  int number = 0;
  for (const QString& line : QString::fromUtf8(file.readAll()).split('\n')) {
    ++number;
    if (line.startsWith("```"))
      inside = line == "```clicks";
    else if (inside && !line.trimmed().isEmpty())
      lines.push_back({number, line.trimmed()});
  }
  if (lines.empty()) throw std::runtime_error{page + " has no block of clicks"};
  copyData(fs::current_path(), folder_.path());
  fs::current_path(folder_.path());
  fs::create_directories("out/logs");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // What is answered comes behind what asks for it.
    QStringList answers;
    const Line& line = lines[i];
    const QString answer = "answer ";
    for (; i + 1 < lines.size() && lines[i + 1].text.startsWith(answer); ++i) {
      answers << lines[i + 1].text.mid(answer.size());
      // Who saves a file makes its folder in the dialog.
      QDir{}.mkpath(QFileInfo{answers.back()}.path());
    }
    std::printf("%d: %s\n", line.number, qPrintable(line.text));
    std::fflush(stdout);
    try {
      if (hand_) hand_->expectQuestions(answers);
      perform(line.text);
      if (hand_) hand_->finishQuestions();
    } catch (const std::exception& fault) {
      if (window_ && !pictures_.empty())
        savePicture(window_->grab(), QString::fromStdString(pictures_) + "/failed.png");
      throw std::runtime_error{page + ":" + std::to_string(line.number) + ": " +
                               line.text.toStdString() + ": " + fault.what()};
    }
  }
}

}  // namespace gt
