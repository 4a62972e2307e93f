#include <QHeaderView>
#include <QInputDialog>
#include <QJsonArray>
#include <QLabel>
#include <QPainter>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>

#include "views/ViewText.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"

namespace gt {
namespace {

constexpr std::int64_t leadMs = 2000;  ///< Before an event, a double click goes to.

/// Something at a time, such as a goal or what somebody wrote.
struct Mark {
  Time time;
  QString text;
  bool own = false;  ///< A person's.
};

/// A slider over time with a line for each mark.
class MarkedSlider : public QSlider {
 public:
  MarkedSlider() : QSlider{Qt::Horizontal} {}
  void show(const std::vector<Mark>& marks) {
    marks_ = marks;
    update();
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    QSlider::paintEvent(event);
    QStyleOptionSlider option;
    initStyleOption(&option);
    const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
    QPainter painter{this};
    for (const Mark& mark : marks_) {
      painter.setPen(QPen{mark.own ? QColor{"#d08000"} : palette().color(QPalette::Highlight), 2});
      const int x =
          handle / 2 + QStyle::sliderPositionFromValue(
                           minimum(), maximum(), static_cast<int>(mark.time.ms), width() - handle);
      painter.drawLine(x, 0, x, height() / 4);
    }
  }

 private:
  std::vector<Mark> marks_;
};

/// All that has happened so far on one line of time: of the simulation with marks from the
/// referee's events and from people, or of the log that the connected robot runs on. Moving back
/// moves the simulation back in time; later events may then change.
class Timeline : public Dialog {
 public:
  explicit Timeline(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(4, 4, 4, 4);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    slider_ = new MarkedSlider;
    slider_->setObjectName("time");
    slider_->setToolTip("Let go, it goes there: back in time by doing all again up to then");
    slider_->setTracking(false);
    QObject::connect(slider_, &QSlider::sliderMoved, this, [this](int ms) { showPlace(Time{ms}); });
    QObject::connect(slider_, &QSlider::sliderReleased, this,
                     [this] { goTo(Time{slider_->sliderPosition()}); });
    QObject::connect(slider_, &QSlider::actionTriggered, this, [this](int action) {
      if (action != QAbstractSlider::SliderMove) goTo(Time{slider_->sliderPosition()});
    });
    row->addWidget(slider_, 1);
    place_ = new QLabel;
    place_->setObjectName("place");
    row->addWidget(place_);
    addButton(*row, *this, "bookmark", "Bookmark…", "Marks the time of now",
              [this] { mark(QInputDialog::getText(this, "Bookmark", "What happens here:")); });
    addButton(*row, *this, "remove", "Remove", "Removes the bookmark that is marked",
              [this] { removeMark(); });
    list_ = makeControl<QTreeWidget>("marks", "A double click goes to two seconds before it");
    list_->setHeaderLabels({"Time", "What"});
    list_->setRootIsDecorated(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    QObject::connect(list_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* item) {
      goTo(Time{std::max<std::int64_t>(0, timeOf(*item).ms - leadMs)});
    });
    layout->addWidget(list_);
  }

  /// Bookmarks.
  QJsonObject settings() const override {
    QJsonArray own;
    for (const Mark& mark : own_)
      own.append(QJsonArray{static_cast<double>(mark.time.ms), mark.text});
    return {{"bookmarks", own}};
  }
  void restore(const QJsonObject& settings) override {
    own_.clear();
    for (const QJsonValue mark : settings["bookmarks"].toArray())
      own_.push_back(
          {Time{static_cast<std::int64_t>(mark[0].toDouble())}, mark[1].toString(), true});
    showMarks();
  }

  void refresh() override {
    const SessionStatus status = session().status();
    log_ = status.log;
    now_ = log_ ? Time{std::llround(1000 * (log_->now - log_->begin))} : status.time;
    const std::string about = log_ ? log_->file : status.scene + std::to_string(status.seed);
    if (about != about_) {
      about_ = about;
      last_ = {};
      events_.clear();
      showMarks();
    }
    last_ = log_ ? Time{std::llround(1000 * (log_->end - log_->begin))} : std::max(last_, now_);
    slider_->setRange(0, static_cast<int>(last_.ms));
    slider_->setPageStep(static_cast<int>(leadMs));
    slider_->setSingleStep(static_cast<int>(leadMs / 10));
    if (!slider_->isSliderDown() && !session().busy()) {
      slider_->setValue(static_cast<int>(now_.ms));
      showPlace(now_);
    }
    if (!log_) askForEvents();
  }
  /// Adds a bookmark for now.
  void mark(const QString& text) {
    if (text.trimmed().isEmpty()) return;
    own_.push_back({now_, text, true});
    showMarks();
  }

 private:
  void goTo(Time there) {
    const std::string ms = std::to_string(there.ms);
    if (log_)
      session().executeFor(
          log_->robot,
          "lp time " + std::to_string(log_->begin + static_cast<double>(there.ms) / 1000));
    else if (there < now_)
      session().execute("rewind " + ms + " ms");
    else if (there > now_)
      session().execute("run " + std::to_string(there - now_) + " ms");
  }
  void showPlace(Time there) {
    place_->setText(QString::fromStdString(clockText(there) + " of " + clockText(last_)));
  }

  /// Requests the referee's events. Events after a time to which a person has gone back stay until
  /// that time is reached again.
  void askForEvents() {
    if (asked_ || session().version() == version_) return;
    asked_ = true;
    version_ = session().version();
    session().ask(
        this,
        [](Console& console) {
          std::vector<Mark> events;
          for (const GameEvent& event : console.session().simulation().referee().events())
            events.push_back({event.time, QString::fromStdString(describe(event))});
          return std::pair{console.session().time(), std::move(events)};
        },
        [this](std::pair<Time, std::vector<Mark>>& answer) {
          asked_ = false;
          auto& [now, events] = answer;
          for (Mark& event : events_)
            if (event.time > now) events.push_back(std::move(event));
          const bool same = std::ranges::equal(events, events_, {}, &Mark::time, &Mark::time);
          events_ = std::move(events);
          if (!same) showMarks();
        });
  }

  static Time timeOf(const QTreeWidgetItem& item) {
    return Time{item.data(0, Qt::UserRole).toLongLong()};
  }
  void showMarks() {
    std::vector<Mark> all = own_;
    if (!log_) all.insert(all.end(), events_.begin(), events_.end());
    std::ranges::stable_sort(all, {}, &Mark::time);
    slider_->show(all);
    list_->clear();
    for (const Mark& mark : all) {
      auto* item =
          new QTreeWidgetItem{list_, {QString::fromStdString(clockText(mark.time)), mark.text}};
      item->setData(0, Qt::UserRole, static_cast<qlonglong>(mark.time.ms));
    }
  }
  void removeMark() {
    const QTreeWidgetItem* const item = list_->currentItem();
    if (!item) return;
    std::erase_if(own_, [&](const Mark& mark) {
      return mark.time == timeOf(*item) && mark.text == item->text(1);
    });
    showMarks();
  }

  MarkedSlider* slider_;
  QLabel* place_;
  QTreeWidget* list_;
  std::vector<Mark> events_, own_;
  std::optional<LogPlace> log_;
  Time now_, last_;
  std::string about_;  ///< Which scene and seed, or log.
  bool asked_ = false;
  std::uint64_t version_ = 0;
};

const RegisterDialog<Timeline> registeredTimeline{
    {.id = "timeline",
     .title = "Timeline",
     .group = "Session",
     .help = "What has happened so far, with bookmarks; goes back in time",
     .place = DialogPlace::bottom}};

}  // namespace
}  // namespace gt
