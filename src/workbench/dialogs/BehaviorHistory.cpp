#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QSlider>
#include <QSplitter>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <deque>
#include <map>

#include "workbench/BehaviorTraces.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/RobotMenu.h"
#include "xabsl/tools/trace/TraceFile.h"
#include "xabsl/tools/trace/TracePrinter.h"

namespace gt {
namespace {

constexpr double keptMs = 600'000, gapMs = 200;
constexpr int rowHeight = 20, namesWidth = 170;

/// A state of an option, for as long as it was active.
struct Span {
  int state = 0;
  double begin = 0, end = 0;  ///< ms
  std::string why;            ///< What was decided in the cycle in which it began.
};

/// States of options over time, made of traces.
class BehaviorSpans {
 public:
  void take(const std::string& part) {
    if (part.starts_with("xabsl")) {
      auto reading = xabsl::readTraces("trace", part);
      if (reading.traces.empty()) return;
      trace_ = std::move(reading.traces.back());
      rows_.clear();
      order_.clear();
    } else if (trace_.subject.model.options.empty() || readMore(trace_, "trace", part)) {
      return;
    }
    xabsl::forEachCycle(trace_.events,
                        [this](const auto* first, const auto* last) { takeCycle(first, last); });
    trace_.events.clear();
  }
  void clear() {
    rows_.clear();
    order_.clear();
  }

  double newest() const { return newest_; }
  /// Options in the order in which they were active first.
  const std::vector<int>& options() const { return order_; }
  const std::deque<Span>& of(int option) const { return rows_.at(option); }
  const std::string& nameOf(int option) const {
    return trace_.subject.model.options[static_cast<std::size_t>(option)].name;
  }
  const std::string& stateName(const Span& span) const {
    return trace_.subject.state(span.state).name;
  }

 private:
  void takeCycle(const xabsl::TraceEvent* first, const xabsl::TraceEvent* last) {
    const double now = first->value;
    if (now < newest_) goBack(now);
    newest_ = now;
    for (const auto* event = first; event != last; ++event) {
      if (event->kind != xabsl::TraceEvent::Kind::state) continue;
      const int option = trace_.subject.optionOf(event->index);
      if (!rows_.contains(option)) order_.push_back(option);
      std::deque<Span>& row = rows_[option];
      if (row.empty() || row.back().state != event->index || now - row.back().end > gapMs)
        row.push_back({event->index, now, now, printCycle(trace_.subject, first, last)});
      row.back().end = now;
      while (row.front().end < now - keptMs) row.pop_front();
    }
  }
  /// Removes everything after a time (s) to which the robot has gone back.
  void goBack(double now) {
    for (auto& [option, row] : rows_) {
      while (!row.empty() && row.back().begin >= now) row.pop_back();
      if (!row.empty()) row.back().end = std::min(row.back().end, now);
    }
  }

  xabsl::Trace trace_;
  std::map<int, std::deque<Span>> rows_;
  std::vector<int> order_;
  double newest_ = 0;
};

/// A row for each option, in which its states follow each other.
class Strip : public QWidget {
 public:
  explicit Strip(const BehaviorSpans& spans) : spans_{spans} {
    setObjectName("strip");
    setToolTip("A click on a state shows why it began");
  }
  /// Shows the time from there to the newest, or up to where it was stopped.
  void show(double seconds, double end) {
    begin_ = end - 1000 * seconds;
    end_ = end;
    setMinimumHeight(rowHeight * static_cast<int>(spans_.options().size()));
    update();
  }
  void select(const Span* span) { selected_ = span ? span->why : std::string{}; }
  std::function<void(const Span&)> clicked;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter{this};
    int y = 0;
    for (const int option : spans_.options()) {
      const auto name = QString::fromStdString(spans_.nameOf(option));
      painter.setPen(palette().color(QPalette::WindowText));
      painter.drawText(QRect{2, y, namesWidth - 6, rowHeight}, Qt::AlignVCenter,
                       fontMetrics().elidedText(name, Qt::ElideMiddle, namesWidth - 8));
      for (const Span& span : spans_.of(option))
        if (span.end >= begin_ && span.begin <= end_) paint(painter, span, y);
      y += rowHeight;
    }
  }
  void mousePressEvent(QMouseEvent* event) override {
    if (const Span* span = at(event->pos()); span && clicked) clicked(*span);
  }
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ToolTip) {
      const auto* help = static_cast<QHelpEvent*>(event);
      const Span* const span = at(help->pos());
      const QString text = span ? QString{"%1, for %2 s"}
                                      .arg(QString::fromStdString(spans_.stateName(*span)))
                                      .arg((span->end - span->begin) / 1000, 0, 'f', 1)
                                : toolTip();
      QToolTip::showText(help->globalPos(), text, this);
      return true;
    }
    return QWidget::event(event);
  }

 private:
  double x(double ms) const {
    return namesWidth + (width() - namesWidth) * (ms - begin_) / (end_ - begin_);
  }
  void paint(QPainter& painter, const Span& span, int y) const {
    const double left = std::max(x(span.begin), 1.0 * namesWidth);
    const QRectF place{left, y + 1.0, std::max(2.0, x(span.end) - left), rowHeight - 2.0};
    // Neighboring numbers get colors that differ.
    constexpr int hueStep = 97, wheel = 360;
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    painter.fillRect(place, QColor::fromHsl(span.state * hueStep % wheel, 110, dark ? 80 : 190));
    if (!selected_.empty() && span.why == selected_) {
      painter.setPen(QPen{palette().color(QPalette::Highlight), 2});
      painter.drawRect(place);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const auto name = QString::fromStdString(spans_.stateName(span));
    if (place.width() > 24)
      painter.drawText(
          place.adjusted(3, 0, -1, 0), Qt::AlignVCenter,
          fontMetrics().elidedText(name, Qt::ElideRight, static_cast<int>(place.width()) - 4));
  }
  const Span* at(const QPoint& point) const {
    const auto row = static_cast<std::size_t>(std::max(0, point.y()) / rowHeight);
    if (row >= spans_.options().size() || point.x() < namesWidth) return nullptr;
    for (const Span& span : spans_.of(spans_.options()[row]))
      if (x(span.begin) <= point.x() && point.x() <= x(span.end) + 2) return &span;
    return nullptr;
  }

  const BehaviorSpans& spans_;
  double begin_ = 0, end_ = 1;
  std::string selected_;
};

/// The states of all options over time, and why each of them began.
class BehaviorHistory : public Dialog {
 public:
  explicit BehaviorHistory(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    auto* row = new QHBoxLayout;
    layout->addLayout(row);
    place_ = new QLabel;
    row->addWidget(place_, 1);
    seconds_ = makeControl<QSlider>("seconds", "How many seconds are shown", Qt::Horizontal);
    seconds_->setRange(2, 120);
    seconds_->setValue(15);
    seconds_->setMaximumWidth(160);
    QObject::connect(seconds_, &QSlider::valueChanged, this, [this] { showStrip(); });
    row->addWidget(seconds_);
    auto* parts = new QSplitter{Qt::Vertical};
    layout->addWidget(parts, 1);
    strip_ = new Strip{spans_};
    strip_->clicked = [this](const Span& span) {
      why_->setPlainText(QString::fromStdString(span.why));
      strip_->select(&span);
      strip_->update();
    };
    auto* area = new QScrollArea;
    area->setWidgetResizable(true);
    area->setWidget(strip_);
    parts->addWidget(area);
    why_ = new QPlainTextEdit;
    why_->setObjectName("why");
    why_->setReadOnly(true);
    why_->setLineWrapMode(QPlainTextEdit::NoWrap);
    why_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    why_->setPlaceholderText(
        "A click on a state shows the cycle in which it began: conditions, and what was read");
    parts->addWidget(why_);
    parts->setStretchFactor(0, 2);
    parts->setStretchFactor(1, 1);
  }

  QJsonObject settings() const override {
    return {{"robot", QString::fromStdString(robot_)}, {"seconds", seconds_->value()}};
  }
  void restore(const QJsonObject& settings) override {
    seconds_->setValue(settings["seconds"].toInt(seconds_->value()));
    setRobot(settings["robot"].toString().toStdString());
  }

  void refresh() override {
    if (traces_.beganAnew()) spans_.clear();
    const auto parts = traces_.takeParts();
    for (const std::string& part : parts) spans_.take(part);
    if (!parts.empty()) showStrip();
  }

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override {
    QMenu menu;
    addRobotMenu(menu, session(), robot_, [this](const std::string& robot) { setRobot(robot); });
    menu.exec(event->globalPos());
  }

 private:
  void setRobot(const std::string& robot) {
    robot_ = robot;
    spans_.clear();
    traces_.follow(robot);
  }
  void showStrip() {
    strip_->show(seconds_->value(), spans_.newest());
    place_->setText(QString{"%1 s shown, up to %2 s of the robot's time"}
                        .arg(seconds_->value())
                        .arg(spans_.newest() / 1000, 0, 'f', 1));
  }

  BehaviorSpans spans_;
  QLabel* place_;
  QSlider* seconds_;
  Strip* strip_;
  QPlainTextEdit* why_;
  std::string robot_;  ///< Empty: the connected one.
  BehaviorTraces traces_{session()};
};

const RegisterDialog<BehaviorHistory> registeredBehaviorHistory{
    {.id = "behaviorHistory",
     .title = "Behavior history",
     .group = "Viewers",
     .help = "The states of all options over time; a click shows why one began",
     .report = "J.5.1",
     .place = DialogPlace::bottom,
     .several = true}};

}  // namespace
}  // namespace gt
