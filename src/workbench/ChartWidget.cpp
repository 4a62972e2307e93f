#include "workbench/ChartWidget.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "base/Number.h"
#include "base/Program.h"

namespace gt {
namespace {

/// Graphviz measures in inches; a unit of ours is a point.
constexpr double inch = 72;
constexpr double fontSize = 11, nodeHeight = 24, padding = 20, pointSize = 8;
constexpr double mostZoom = 20, margin = 8;
/// Larger graphs are drawn with straight arrows; finding the best curves would take minutes.
constexpr std::size_t large = 250;

QFont chartFont(QFont font) {
  font.setPixelSize(static_cast<int>(fontSize));
  return font;
}

std::string dotText(const ChartPlan& plan, const std::vector<QSizeF>& sizes) {
  std::string text = "digraph {\n  nodesep=0.15; ranksep=0.4; rankdir=";
  text += plan.leftToRight ? "LR" : "TB";
  text += ";\n  node [shape=box, fixedsize=true, label=\"\"]; edge [arrowsize=0.7];\n";
  if (plan.nodes.size() + plan.edges.size() > large)
    text += "  splines=line; nslimit=1; nslimit1=1; mclimit=0.05;\n";
  for (std::size_t i = 0; i < plan.nodes.size(); ++i)
    text += "  n" + std::to_string(i) + " [width=" + numberText(sizes[i].width() / inch) +
            ", height=" + numberText(sizes[i].height() / inch) + "];\n";
  for (const ChartPlan::Edge& edge : plan.edges)
    text += "  n" + std::to_string(edge.from) + " -> n" + std::to_string(edge.to) + ";\n";
  return text + "}\n";
}

/// The node that a word names; -1: none.
int nodeOf(const std::string& word, std::size_t count) {
  const auto number = numberFrom<int>(std::string_view{word}.substr(word.empty() ? 0 : 1));
  return number && *number >= 0 && static_cast<std::size_t>(*number) < count ? *number : -1;
}

}  // namespace

ChartWidget::ChartWidget(QWidget* parent) : QWidget{parent} {
  setMinimumSize(160, 100);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ChartWidget::showChart(ChartPlan plan) {
  // One at a time: dot is not stopped, and the window does not wait for it.
  if (placing_.running()) {
    waiting_ = std::move(plan);
    return;
  }
  next_ = std::move(plan);
  const QFontMetricsF metrics{chartFont(font())};
  std::vector<QSizeF> sizes;
  for (const ChartPlan::Node& node : next_.nodes)
    sizes.push_back(node.shape == ChartPlan::Shape::point
                        ? QSizeF{pointSize, pointSize}
                        : QSizeF{metrics.horizontalAdvance(node.label) + padding, nodeHeight});
  placing_.start(
      this,
      [plan = next_, sizes = std::move(sizes)](const Background::Progress&) {
        return place(plan, sizes);
      },
      [this](Result<Placed>& placed) {
        fault_ = placed ? QString{} : QString::fromStdString(placed.error().text());
        placed_ = placed ? std::move(*placed) : Placed{};
        plan_ = placed ? std::move(next_) : ChartPlan{};
        nodeLights_.clear();
        edgeLights_.clear();
        selected_.reset();
        zoom_ = 1;
        moved_ = {};
        update();
        if (auto waiting = std::exchange(waiting_, std::nullopt)) showChart(std::move(*waiting));
      });
}

Result<ChartWidget::Placed> ChartWidget::place(const ChartPlan& plan,
                                               const std::vector<QSizeF>& sizes) {
  Placed placed;
  if (plan.nodes.empty()) return placed;
  const auto done = runProgram({"dot", "-Tplain"}, dotText(plan, sizes));
  if (!done || done->status != 0)
    return Error{.field = "dot", .what = "Graphviz's program dot is missing or failed"};
  placed.nodes.resize(plan.nodes.size());
  placed.edges.resize(plan.edges.size());
  std::vector<bool> known(plan.edges.size());
  std::istringstream lines{done->output};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in{line};
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    const auto number = [&](std::size_t i) {
      return i < words.size() ? inch * numberFrom<double>(words[i]).value_or(0) : 0;
    };
    if (words.size() > 3 && words[0] == "graph") {
      placed.size = {number(2), number(3)};
    } else if (words.size() > 5 && words[0] == "node") {
      const int node = nodeOf(words[1], plan.nodes.size());
      if (node >= 0)
        placed.nodes[static_cast<std::size_t>(node)] = {
            number(2) - number(4) / 2, placed.size.height() - number(3) - number(5) / 2, number(4),
            number(5)};
    } else if (words.size() > 3 && words[0] == "edge") {
      readEdge(plan, words, known, placed);
    }
  }
  return placed;
}

/// edge FROM TO N X Y …: the points of a curve.
void ChartWidget::readEdge(const ChartPlan& plan, const std::vector<std::string>& words,
                           std::vector<bool>& known, Placed& placed) {
  const int from = nodeOf(words[1], plan.nodes.size()), to = nodeOf(words[2], plan.nodes.size());
  std::vector<QPointF> points;
  const auto count = numberFrom<std::size_t>(words[3]).value_or(0);
  for (std::size_t i = 0; i < count && 5 + 2 * i < words.size(); ++i)
    points.emplace_back(
        inch * numberFrom<double>(words[4 + 2 * i]).value_or(0),
        placed.size.height() - inch * numberFrom<double>(words[5 + 2 * i]).value_or(0));
  if (points.size() < 4) return;
  for (std::size_t i = 0; i < plan.edges.size(); ++i) {
    if (known[i] || plan.edges[i].from != from || plan.edges[i].to != to) continue;
    known[i] = true;
    QPainterPath path{points.front()};
    for (std::size_t k = 1; k + 2 < points.size(); k += 3)
      path.cubicTo(points[k], points[k + 1], points[k + 2]);
    placed.edges[i] = {path, points.back(), points[points.size() - 2]};
    return;
  }
}

void ChartWidget::light(std::vector<double> nodes, std::vector<double> edges) {
  if (nodes == nodeLights_ && edges == edgeLights_) return;
  nodeLights_ = std::move(nodes);
  edgeLights_ = std::move(edges);
  update();
}

void ChartWidget::select(std::optional<int> node) {
  selected_ = node;
  update();
}

QTransform ChartWidget::toWidget() const {
  const double fitting = std::min((width() - 2 * margin) / placed_.size.width(),
                                  (height() - 2 * margin) / placed_.size.height());
  // Small graphs are not blown up.
  const double scale = zoom_ * std::min(1.6, fitting);
  QTransform transform;
  transform.translate(width() / 2.0 + moved_.x(), height() / 2.0 + moved_.y());
  transform.scale(scale, scale);
  transform.translate(-placed_.size.width() / 2, -placed_.size.height() / 2);
  return transform;
}

std::optional<QRectF> ChartWidget::placeOf(int node) const {
  if (node < 0 || static_cast<std::size_t>(node) >= placed_.nodes.size()) return std::nullopt;
  return toWidget().mapRect(placed_.nodes[static_cast<std::size_t>(node)]);
}

std::optional<int> ChartWidget::nodeAt(const QPointF& at) const {
  for (std::size_t i = 0; i < placed_.nodes.size(); ++i)
    if (placeOf(static_cast<int>(i))->contains(at)) return static_cast<int>(i);
  return std::nullopt;
}

void ChartWidget::paintEvent(QPaintEvent*) {
  QPainter painter{this};
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (!fault_.isEmpty()) {
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignCenter | Qt::TextWordWrap, fault_);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setTransform(toWidget());
  painter.setFont(chartFont(font()));
  for (std::size_t i = 0; i < placed_.edges.size(); ++i) paintEdge(painter, i);
  for (std::size_t i = 0; i < placed_.nodes.size(); ++i) paintNode(painter, i);
}

void ChartWidget::paintEdge(QPainter& painter, std::size_t edge) const {
  const Placed::Arrow& arrow = placed_.edges[edge];
  if (arrow.path.isEmpty()) return;
  const double light = edge < edgeLights_.size() ? edgeLights_[edge] : 0;
  QColor color = palette().color(QPalette::Text);
  color.setAlpha(110);
  if (light > 0) {
    color = QColor{0xe0, 0x70, 0x10};
    color.setAlphaF(static_cast<float>(0.3 + 0.7 * light));
  }
  QPen pen{color, light > 0 ? 2.2 : 1};
  if (plan_.edges[edge].dotted) pen.setStyle(Qt::DotLine);
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(arrow.path);
  // The curve ends where the arrow's head begins.
  constexpr double length = 7;
  QPointF along = arrow.end - arrow.before;
  along /= std::max(1e-6, std::hypot(along.x(), along.y()));
  const QPointF across{-along.y(), along.x()};
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(
      QPolygonF{{arrow.end + length * along, arrow.end + 3 * across, arrow.end - 3 * across}});
}

void ChartWidget::paintNode(QPainter& painter, std::size_t node) const {
  using Shape = ChartPlan::Shape;
  const QRectF place = placed_.nodes[node];
  const Shape shape = plan_.nodes[node].shape;
  const double light = node < nodeLights_.size() ? std::clamp(nodeLights_[node], 0.0, 1.0) : 0;
  const QColor dark = palette().color(QPalette::Window), text = palette().color(QPalette::Text);
  const QColor lit{0xff, 0xb0, 0x30};
  const auto between = [&](int a, int b) { return static_cast<int>(a + light * (b - a)); };
  painter.setBrush(QColor{between(dark.red(), lit.red()), between(dark.green(), lit.green()),
                          between(dark.blue(), lit.blue())});
  const bool selected = selected_ == static_cast<int>(node);
  QPen pen{selected ? palette().color(QPalette::Highlight) : text, selected ? 2.5 : 1};
  if (shape == Shape::dashed) pen.setStyle(Qt::DashLine);
  painter.setPen(pen);
  if (shape == Shape::point) {
    painter.setBrush(text);
    painter.drawEllipse(place);
    return;
  }
  if (shape == Shape::ellipse || shape == Shape::doubleEllipse) {
    painter.drawRoundedRect(place, nodeHeight / 2, nodeHeight / 2);
    if (shape == Shape::doubleEllipse)
      painter.drawRoundedRect(place.adjusted(2.5, 2.5, -2.5, -2.5), nodeHeight / 2 - 2.5,
                              nodeHeight / 2 - 2.5);
  } else {
    const double radius = shape == Shape::rounded ? 7 : 1;
    painter.drawRoundedRect(place, radius, radius);
  }
  constexpr double bright = 0.4;  // then letters are black in dark windows, too
  painter.setPen(light > bright ? QColor{Qt::black} : text);
  painter.drawText(place, Qt::AlignCenter, plan_.nodes[node].label);
}

bool ChartWidget::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const auto node = nodeAt(help->pos());
  QToolTip::showText(help->globalPos(),
                     node ? plan_.nodes[static_cast<std::size_t>(*node)].tip : toolTip(), this);
  return true;
}

void ChartWidget::wheelEvent(QWheelEvent* event) {
  const QPointF before = toWidget().inverted().map(event->position());
  constexpr double stepsAngle = 120, factor = 1.2;
  zoom_ = std::clamp(zoom_ * std::pow(factor, event->angleDelta().y() / stepsAngle), 1.0, mostZoom);
  if (zoom_ == 1)
    moved_ = {};
  else
    moved_ += event->position() - toWidget().map(before);
  update();
}

void ChartWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) drag_ = event->position();
  wasDragged_ = false;
}

void ChartWidget::mouseMoveEvent(QMouseEvent* event) {
  if (!drag_) return;
  const QPointF by = event->position() - *drag_;
  constexpr double least = 4;
  if (!wasDragged_ && std::hypot(by.x(), by.y()) < least) return;
  wasDragged_ = true;
  drag_ = event->position();
  moved_ += by;
  update();
}

void ChartWidget::mouseReleaseEvent(QMouseEvent* event) {
  const auto node = nodeAt(event->position());
  if (drag_ && !wasDragged_ && node && clicked) clicked(*node);
  drag_.reset();
}

void ChartWidget::mouseDoubleClickEvent(QMouseEvent*) {
  zoom_ = 1;
  moved_ = {};
  update();
}

}  // namespace gt
