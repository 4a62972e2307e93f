#include <QCompleter>
#include <QDropEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QSlider>
#include <QStringListModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>

#include "console/Values.h"
#include "streams/File.h"
#include "workbench/CustomPlot.h"
#include "workbench/Dialog.h"
#include "workbench/PlotColors.h"

namespace gt {
namespace {

constexpr QRgb curveColors[] = {0xff2f7ed8, 0xffe4572e, 0xff3a9b52, 0xffb05bc4,
                                0xffd79a1e, 0xff17a2a2, 0xffc2417c, 0xff7f8c9b};
constexpr int shortest = 1, longest = 120;  // s
constexpr std::size_t mostPoints = 2'000'000;

/// New points of a value.
struct Points {
  std::string name;
  std::vector<ObservedRobot::Point> points;
};
struct News {
  Time now;
  std::vector<Points> points;
};

/// A plot of a robot is named by the robot and its debug key: red1 BallLocator/speed.
const std::deque<ObservedRobot::Point>* plotOf(Console& console, const std::string& name) {
  const std::size_t blank = name.find(' ');
  if (blank == name.npos) return nullptr;
  ConsoleRobot* const robot = console.session().find(name.substr(0, blank));
  if (!robot) return nullptr;
  const auto& plots = robot->observed().plots();
  const auto found = plots.find(name.substr(blank + 1));
  return found == plots.end() ? nullptr : &found->second;
}

template <typename List>
void addSince(std::vector<ObservedRobot::Point>& points, const List& list, Time after) {
  const auto begin = std::ranges::upper_bound(list, after, {}, &ObservedRobot::Point::time);
  points.insert(points.end(), begin, list.end());
}

News newsOf(Console& console, const std::map<std::string, Time>& known) {
  News news{console.session().time(), {}};
  for (const auto& [name, after] : known) {
    Points points{name, {}};
    const auto& series = console.recorder().series();
    if (const auto* plot = plotOf(console, name))
      addSince(points.points, *plot, after);
    else if (const auto recorded = series.find(name); recorded != series.end())
      addSince(points.points, recorded->second, after);
    if (!points.points.empty()) news.points.push_back(std::move(points));
  }
  return news;
}

/// All that can be plotted.
std::vector<std::string> choicesOf(Console& console) {
  std::vector<std::string> names = valueNames(console);
  for (ConsoleRobot* robot : console.selected())
    for (const auto& [key, points] : robot->observed().plots())
      names.push_back(robot->name() + " " + key);
  std::ranges::sort(names);
  return names;
}

/// The name of a value for good: what the connected robot has begins with that robot's name.
std::string fullName(Console& console, const std::string& name) {
  const std::string first = name.substr(0, name.find('.'));
  const auto robot = console.firstRobot();
  if (!robot || name.find(' ') != name.npos || console.session().find(first)) return name;
  return (*robot)->observed().has(first) ? (*robot)->name() + "." + name : name;
}

/// Report J.3.5: values over time. Any number of any representation, of the game and of the bodies,
/// and what modules plot.
class PlotViewer : public Dialog {
 public:
  explicit PlotViewer(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    auto* top = new QHBoxLayout;
    input_ = new QLineEdit;
    input_->setObjectName("value");
    input_->setPlaceholderText("Add a value: ball.speed, RobotPose.pose.rotation, …");
    completer_.setModel(&words_);
    completer_.setFilterMode(Qt::MatchContains);
    completer_.setCaseSensitivity(Qt::CaseInsensitive);
    completer_.setMaxVisibleItems(20);
    input_->setCompleter(&completer_);
    QObject::connect(input_, &QLineEdit::returnPressed, this, [this] {
      const QString name = input_->text().trimmed();
      if (!name.isEmpty()) choose(name.toStdString());
    });
    QObject::connect(input_, &QLineEdit::textEdited, this, [this] { complete(); });
    top->addWidget(input_, 1);
    follow_ = new QToolButton;
    follow_->setObjectName("follow");
    follow_->setText("Follow");
    follow_->setCheckable(true);
    follow_->setChecked(true);
    follow_->setToolTip("Shows the newest values; dragging the plot ends that");
    top->addWidget(follow_);
    seconds_ = new QSlider{Qt::Horizontal};
    seconds_->setObjectName("seconds");
    seconds_->setRange(shortest, longest);
    seconds_->setValue(20);
    seconds_->setFixedWidth(120);
    seconds_->setToolTip("How many seconds are shown");
    top->addWidget(seconds_);
    shown_ = new QLabel{"20 s"};
    shown_->setMinimumWidth(40);
    top->addWidget(shown_);
    layout->addLayout(top);
    plot_ = new QCustomPlot;
    plot_->setMinimumHeight(80);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom | QCP::iSelectLegend |
                           QCP::iSelectPlottables);
    plot_->legend->setVisible(true);
    plot_->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
    plot_->xAxis->setNumberFormat("gb");
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setContextMenuPolicy(Qt::CustomContextMenu);
    layout->addWidget(plot_, 1);
    QObject::connect(seconds_, &QSlider::valueChanged, this, [this](int seconds) {
      shown_->setText(QString{"%1 s"}.arg(seconds));
      draw();
    });
    QObject::connect(follow_, &QToolButton::toggled, this, [this] { draw(); });
    QObject::connect(plot_, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
      if (event->button() == Qt::LeftButton) follow_->setChecked(false);
    });
    QObject::connect(plot_, &QCustomPlot::mouseWheel, this, [this] { follow_->setChecked(false); });
    QObject::connect(plot_, &QCustomPlot::mouseMove, this,
                     [this](const QMouseEvent* event) { showValues(event->pos()); });
    QObject::connect(plot_, &QCustomPlot::customContextMenuRequested, this,
                     [this](const QPoint& at) { showMenu(at); });
    setAcceptDrops(true);
    setPlotColors(*plot_, palette());
  }

  QJsonObject settings() const override {
    QJsonArray values;
    for (const auto& [name, curve] : curves_)
      values.append(
          QJsonArray{QString::fromStdString(name), curve.graph->valueAxis() == plot_->yAxis2});
    return {{"values", values}, {"seconds", seconds_->value()}};
  }
  void restore(const QJsonObject& settings) override {
    curves_.clear();
    plot_->clearGraphs();
    seconds_->setValue(settings["seconds"].toInt(20));
    for (const QJsonValue value : settings["values"].toArray())
      add(value[0].toString().toStdString(), value[1].toBool());
  }

  void refresh() override {
    const std::uint64_t version = session().version();
    if (asked_ || version == version_) return;
    version_ = version;
    const std::uint64_t beginnings = session().status().beginnings;
    if (beginnings != beginnings_) {
      beginnings_ = beginnings;
      for (auto& [name, curve] : curves_) {
        curve.last = never();
        curve.graph->data()->clear();
        record(name);
      }
    }
    std::map<std::string, Time> known;
    for (const auto& [name, curve] : curves_) known[name] = curve.last;
    asked_ = true;
    session().ask(
        this, [known](Console& console) { return newsOf(console, known); },
        [this](const News& news) { take(news); });
  }

 protected:
  /// Values are dropped as text, a path a line.
  void dragEnterEvent(QDragEnterEvent* event) override {
    if (event->mimeData()->hasText()) event->acceptProposedAction();
  }
  void dropEvent(QDropEvent* event) override {
    for (const QString& path : event->mimeData()->text().split('\n', Qt::SkipEmptyParts))
      choose(path.toStdString());
    event->acceptProposedAction();
  }
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::PaletteChange) setPlotColors(*plot_, palette());
    Dialog::changeEvent(event);
  }

 private:
  struct Curve {
    QCPGraph* graph = nullptr;
    Time last = never();
  };

  void complete() {
    // All names at once: the completer finds those that hold what is typed.
    if (completing_ || input_->text().size() != 1) return;
    completing_ = true;
    session().ask(this, choicesOf, [this](const std::vector<std::string>& names) {
      completing_ = false;
      QStringList words;
      for (const std::string& name : names) words << QString::fromStdString(name);
      words_.setStringList(words);
    });
  }

  void choose(const std::string& name) {
    session().ask(
        this,
        [name](Console& console) -> Result<std::string> {
          std::string full = fullName(console, name);
          if (plotOf(console, full)) return full;
          const auto value = valueAt(console, full);
          if (!value) return value.error();
          if (!value->number) return Error{.field = name, .what = "is no number"};
          return full;
        },
        [this](const Result<std::string>& full) {
          input_->setStyleSheet(full ? "" : "color: #d04030");
          input_->setToolTip(full ? QString{} : QString::fromStdString(full.error().text()));
          if (!full) return;
          input_->clear();
          add(*full, false);
        });
  }

  void add(const std::string& name, bool right) {
    if (name.empty() || curves_.contains(name)) return;
    QCPGraph* graph = plot_->addGraph(plot_->xAxis, right ? plot_->yAxis2 : plot_->yAxis);
    graph->setName(QString::fromStdString(name));
    graph->setPen(QPen{QColor{curveColors[colors_++ % std::size(curveColors)]}, 1.5});
    graph->setAdaptiveSampling(true);
    curves_[name] = {graph, never()};
    plot_->yAxis2->setVisible(plot_->yAxis2->visible() || right);
    version_ = 0;
    record(name);
  }

  void record(const std::string& name) {
    if (name.find(' ') == name.npos) session().executeQuietly("plot \"" + name + "\" on");
  }

  void remove(const std::string& name) {
    const auto curve = curves_.find(name);
    if (curve == curves_.end()) return;
    plot_->removeGraph(curve->second.graph);
    curves_.erase(curve);
    draw();
  }

  void take(const News& news) {
    asked_ = false;
    now_ = static_cast<double>(news.now.ms) / 1000;
    for (const Points& fresh : news.points) {
      const auto known = curves_.find(fresh.name);
      if (known == curves_.end()) continue;
      Curve& curve = known->second;
      QVector<double> times, values;
      for (const auto& [time, value] : fresh.points) {
        times << static_cast<double>(time.ms) / 1000;
        values << value;
      }
      if (curve.graph->dataCount() > static_cast<int>(mostPoints))
        curve.graph->data()->removeBefore(now_ - longest);
      curve.graph->addData(times, values, true);
      curve.last = fresh.points.back().time;
    }
    draw();
  }

  void draw() {
    if (follow_->isChecked()) {
      plot_->xAxis->setRange(now_ - seconds_->value(), now_);
      for (QCPAxis* axis : {plot_->yAxis, plot_->yAxis2}) fit(axis);
    }
    plot_->legend->setVisible(!curves_.empty());
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }

  /// Fits an axis to what can be seen of its curves.
  void fit(QCPAxis* axis) {
    bool any = false;
    QCPRange all;
    for (const auto& [name, curve] : curves_) {
      if (curve.graph->valueAxis() != axis) continue;
      bool found = false;
      const QCPRange range = curve.graph->getValueRange(found, QCP::sdBoth, plot_->xAxis->range());
      if (!found) continue;
      if (any)
        all.expand(range);
      else
        all = range;
      any = true;
    }
    if (!any) return;
    const double margin =
        all.size() > 0 ? 0.06 * all.size() : std::max(1.0, 0.1 * std::abs(all.lower));
    axis->setRange(all.lower - margin, all.upper + margin);
  }

  void showValues(const QPoint& at) {
    if (curves_.empty()) return;
    const double time = plot_->xAxis->pixelToCoord(at.x());
    QStringList lines{QString{"%1 s"}.arg(time, 0, 'f', 2)};
    for (const auto& [name, curve] : curves_) {
      const auto point = curve.graph->data()->findBegin(time);
      if (point != curve.graph->data()->constEnd())
        lines << QString{"%1 = %2"}.arg(QString::fromStdString(name)).arg(point->value, 0, 'g', 6);
    }
    plot_->setToolTip(lines.join("\n"));
  }

  void showMenu(const QPoint& at) {
    QMenu menu;
    for (const auto& [name, curve] : curves_) {
      QMenu* part = menu.addMenu(QString::fromStdString(name));
      QAction* right = part->addAction("On the right axis");
      right->setCheckable(true);
      right->setChecked(curve.graph->valueAxis() == plot_->yAxis2);
      QObject::connect(right, &QAction::toggled, this, [this, graph = curve.graph](bool on) {
        graph->setValueAxis(on ? plot_->yAxis2 : plot_->yAxis);
        plot_->yAxis2->setVisible(std::ranges::any_of(curves_, [this](const auto& known) {
          return known.second.graph->valueAxis() == plot_->yAxis2;
        }));
        draw();
      });
      part->addAction("Remove", this, [this, removed = name] { remove(removed); });
    }
    menu.addSeparator();
    menu.addAction("Export as CSV…", this,
                   [this] {
                     const QString file = QFileDialog::getSaveFileName(
                         this, "Export", "out/plot.csv", "Tables (*.csv)");
                     if (!file.isEmpty()) static_cast<void>(exportTo(file.toStdString()));
                   })
        ->setEnabled(!curves_.empty());
    menu.addAction("Save as picture…", this, [this] {
      const QString file =
          QFileDialog::getSaveFileName(this, "Save", "plot.png", "Images (*.png);;PDF (*.pdf)");
      if (file.endsWith(".pdf"))
        plot_->savePdf(file);
      else if (!file.isEmpty())
        plot_->savePng(file, 0, 0, 2);
    });
    menu.exec(plot_->mapToGlobal(at));
  }

 public:
  /// Writes all points, a line for each time.
  Result<void> exportTo(const std::string& file) const {
    std::map<double, std::map<std::string, double>> rows;
    std::string text = "time";
    for (const auto& [name, curve] : curves_) {
      text += "," + name;
      for (const QCPGraphData& point : *curve.graph->data()) rows[point.key][name] = point.value;
    }
    text += "\n";
    for (const auto& [time, values] : rows) {
      text += QString::number(time, 'f', 3).toStdString();
      for (const auto& [name, curve] : curves_) {
        const auto value = values.find(name);
        text +=
            "," + (value == values.end() ? std::string{}
                                         : QString::number(value->second, 'g', 9).toStdString());
      }
      text += "\n";
    }
    return writeFile(file, text);
  }

 private:
  QLineEdit* input_;
  QToolButton* follow_;
  QSlider* seconds_;
  QLabel* shown_;
  QCustomPlot* plot_;
  QStringListModel words_;
  QCompleter completer_;
  std::map<std::string, Curve> curves_;
  std::size_t colors_ = 0;
  double now_ = 0;
  std::uint64_t version_ = 0, beginnings_ = 0;
  bool asked_ = false, completing_ = false;
};

const RegisterDialog<PlotViewer> registered{
    {.id = "plot",
     .title = "Value history",
     .group = "Viewers",
     .help = "Any numbers over time: of representations, bodies, the game, and what modules plot",
     .report = "J.3.5",
     .place = DialogPlace::bottom,
     .several = true,
     .atFirst = true}};

}  // namespace
}  // namespace gt
