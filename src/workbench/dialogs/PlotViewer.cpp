#include <QCompleter>
#include <QDropEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QSlider>
#include <QStringListModel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "workbench/Control.h"
#include "workbench/CurvePlot.h"
#include "workbench/Dialog.h"
#include "workbench/PlotColors.h"
#include "workbench/PlotCursors.h"
#include "workbench/PlottedValues.h"
#include "workbench/SaveImage.h"

namespace gt {
namespace {

constexpr int shortest = 1, longestHistory = 120;  // s
constexpr const char* inputHelp = "A value that is plotted, too; Enter adds it";

/// Report J.3.5: values over time. Any number of any representation, of the game and of the bodies,
/// and what modules plot.
class PlotViewer : public Dialog {
 public:
  explicit PlotViewer(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    auto* top = new QHBoxLayout;
    input_ = makeControl<QLineEdit>("value", inputHelp);
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
    follow_ =
        makeControl<QToolButton>("follow", "Shows the newest values; dragging the plot ends that");
    follow_->setText("Follow");
    follow_->setCheckable(true);
    follow_->setChecked(true);
    top->addWidget(follow_);
    seconds_ = makeControl<QSlider>("seconds", "How many seconds are shown", Qt::Horizontal);
    seconds_->setRange(shortest, longestHistory);
    seconds_->setValue(20);
    seconds_->setFixedWidth(120);
    top->addWidget(seconds_);
    cursors_ = makeControl<QToolButton>("cursors", "Two lines to be dragged, and the values there");
    cursors_->setText("Cursors");
    cursors_->setCheckable(true);
    QObject::connect(cursors_, &QToolButton::toggled, this, [this](bool on) {
      cursorValues_->setOn(on);
      if (on) follow_->setChecked(false);
      draw();
    });
    shown_ = new QLabel{"20 s"};
    shown_->setMinimumWidth(40);
    top->addWidget(shown_);
    top->addWidget(cursors_);
    layout->addLayout(top);
    plot_ = new CurvePlot;
    plot_->setMinimumHeight(80);
    plot_->setContextMenuPolicy(Qt::CustomContextMenu);
    layout->addWidget(plot_, 1);
    cursorValues_ = new PlotCursors{*plot_};
    layout->addWidget(cursorValues_);
    QObject::connect(seconds_, &QSlider::valueChanged, this, [this](int seconds) {
      shown_->setText(QString{"%1 s"}.arg(seconds));
      draw();
    });
    QObject::connect(follow_, &QToolButton::toggled, this, [this] { draw(); });
    QObject::connect(plot_, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
      if (event->button() != Qt::LeftButton) return;
      const bool held = cursorValues_->hold(event->pos());
      plot_->setInteraction(QCP::iRangeDrag, !held);
      if (!held) follow_->setChecked(false);
    });
    QObject::connect(plot_, &QCustomPlot::mouseRelease, this, [this] { cursorValues_->letGo(); });
    QObject::connect(plot_, &QCustomPlot::mouseWheel, this, [this] { follow_->setChecked(false); });
    QObject::connect(plot_, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
      if (cursorValues_->drag(event->pos()))
        draw();
      else if (!plot_->curves().empty() && plot_->x().empty())
        plot_->setToolTip(plot_->textAt(plot_->xAxis->pixelToCoord(event->pos().x())));
    });
    QObject::connect(plot_, &QCustomPlot::customContextMenuRequested, this,
                     [this](const QPoint& at) { showMenu(at); });
    setAcceptDrops(true);
    setPlotColors(*plot_, palette());
  }

  QJsonObject settings() const override {
    QJsonArray values;
    for (const auto& [name, curve] : plot_->curves())
      values.append(QJsonArray{QString::fromStdString(name), plot_->axisOf(curve),
                               static_cast<int>(curve.filter.kind())});
    return {{"values", values},
            {"seconds", seconds_->value()},
            {"x", QString::fromStdString(plot_->x())},
            {"cursors", cursors_->isChecked()}};
  }
  void restore(const QJsonObject& settings) override {
    plot_->clear();
    seconds_->setValue(settings["seconds"].toInt(20));
    for (const QJsonValue value : settings["values"].toArray()) {
      // Earlier layouts say only whether it is on the right axis.
      const int axis = value[1].isBool() ? value[1].toBool() : value[1].toInt();
      const int filter = value[2].toInt();
      add(value[0].toString().toStdString(), std::clamp(axis, 0, CurvePlot::axisCount - 1),
          static_cast<CurveFilterKind>(
              std::clamp(filter, 0, static_cast<int>(enumCount<CurveFilterKind>) - 1)));
    }
    setX(settings["x"].toString().toStdString());
    cursors_->setChecked(settings["cursors"].toBool());
  }

  void refresh() override {
    const std::uint64_t version = session().version();
    if (asked_ || version == version_) return;
    version_ = version;
    const std::uint64_t beginnings = session().status().beginnings;
    if (beginnings != beginnings_) {
      beginnings_ = beginnings;
      plot_->keepRuns();
      for (const auto& [name, curve] : plot_->curves()) record(name);
    }
    std::map<std::string, Time> known;
    for (const auto& [name, curve] : plot_->curves()) known[name] = curve.last;
    asked_ = true;
    session().ask(
        this, [known](Console& console) { return PlottedValues::since(console, known); },
        [this](const PlottedValues& news) {
          asked_ = false;
          plot_->take(news);
          draw();
        });
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
  void complete() {
    // All names at once: the completer finds those that hold what is typed.
    if (completing_ || input_->text().size() != 1) return;
    completing_ = true;
    session().ask(this, plottableNames, [this](const std::vector<std::string>& names) {
      completing_ = false;
      QStringList words;
      for (const std::string& name : names) words << QString::fromStdString(name);
      words_.setStringList(words);
    });
  }

  void choose(const std::string& name) {
    session().ask(
        this, [name](Console& console) { return plottableName(console, name); },
        [this](const Result<std::string>& full) {
          input_->setStyleSheet(full ? "" : "color: #d04030");
          input_->setToolTip(full ? QString{inputHelp}
                                  : QString::fromStdString(full.error().text()));
          if (!full) return;
          input_->clear();
          add(*full, 0, CurveFilterKind::none);
        });
  }

  void add(const std::string& name, int axis, CurveFilterKind filter) {
    if (name.empty() || !plot_->add(name, axis, filter)) return;
    version_ = 0;
    record(name);
    draw();
  }
  void setX(const std::string& name) {
    plot_->setX(name);
    follow_->setChecked(true);
    draw();
  }
  void record(const std::string& name) {
    if (name.find(' ') == name.npos) session().executeQuietly("plot \"" + name + "\" on");
  }

  void draw() {
    if (follow_->isChecked()) plot_->follow(seconds_->value());
    cursorValues_->showValues();
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }

  void showMenu(const QPoint& at) {
    QMenu menu;
    const auto choice = [](QMenu* part, const QString& text, bool checked, auto chosen) {
      QAction* action = part->addAction(text, chosen);
      action->setCheckable(true);
      action->setChecked(checked);
    };
    for (const auto& [name, curve] : plot_->curves()) {
      QMenu* part = menu.addMenu(QString::fromStdString(name));
      QMenu* axis = part->addMenu("Axis");
      for (int i = 0; i < CurvePlot::axisCount; ++i)
        choice(axis, CurvePlot::axisNames[i], plot_->axisOf(curve) == i, [this, known = name, i] {
          plot_->setAxis(known, i);
          draw();
        });
      QMenu* filter = part->addMenu("Filter");
      for (const auto& [kind, text] : CurvePlot::filters)
        choice(filter, text, curve.filter.kind() == kind, [this, known = name, k = kind] {
          plot_->setFilter(known, k);
          draw();
        });
      part->addAction("Remove", this, [this, removed = name] {
        plot_->remove(removed);
        draw();
      });
    }
    QMenu* over = menu.addMenu("X axis");
    choice(over, "Time", plot_->x().empty(), [this] { setX({}); });
    for (const auto& [name, curve] : plot_->curves())
      choice(over, QString::fromStdString(name), plot_->x() == name, [this, x = name] { setX(x); });
    menu.addSeparator();
    menu.addAction(
            "Export as CSV…", this,
            [this] {
              const QString file =
                  QFileDialog::getSaveFileName(this, "Export", "out/plot.csv", "Tables (*.csv)");
              if (file.isEmpty()) return;
              if (const auto done = plot_->exportTo(file.toStdString()); !done)
                QMessageBox::warning(this, "Export", QString::fromStdString(done.error().text()));
            })
        ->setEnabled(!plot_->curves().empty());
    menu.addAction("Save as picture…", this, [this] {
      const QString file =
          QFileDialog::getSaveFileName(this, "Save", "plot.png", "Images (*.png);;PDF (*.pdf)");
      if (file.isEmpty()) return;
      const auto done = saveWhole(file, [&](const QString& written) {
        return file.endsWith(".pdf") ? plot_->savePdf(written) : plot_->savePng(written, 0, 0, 2);
      });
      if (!done) QMessageBox::warning(this, "Save", QString::fromStdString(done.error().text()));
    });
    menu.exec(plot_->mapToGlobal(at));
  }

  QLineEdit* input_;
  QToolButton* follow_;
  QSlider* seconds_;
  QLabel* shown_;
  QToolButton* cursors_;
  CurvePlot* plot_;
  PlotCursors* cursorValues_;
  QStringListModel words_;
  QCompleter completer_;
  std::uint64_t version_ = 0, beginnings_ = 0;
  bool asked_ = false, completing_ = false;
};

const RegisterDialog<PlotViewer> registeredPlotViewer{
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
