#pragma once
#include <QPainterPath>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "workbench/Background.h"

namespace gt {

/// A graph to be drawn: nodes, and arrows between nodes given by their indices.
struct ChartPlan {
  enum class Shape { box, rounded, ellipse, doubleEllipse, dashed, point };
  struct Node {
    QString label;
    Shape shape = Shape::box;
    QString tip{};
  };
  struct Edge {
    int from = 0, to = 0;
    bool dotted = false;
    bool operator==(const Edge&) const = default;
  };

  std::vector<Node> nodes;
  std::vector<Edge> edges;
  bool leftToRight = false;
};

/// Shows a graph that is laid out by Graphviz's program dot, and in which nodes and arrows can be
/// lit up. The wheel zooms, dragging moves the graph, a double click shows all of it again.
class ChartWidget : public QWidget {
 public:
  explicit ChartWidget(QWidget* parent = nullptr);

  /// Shows another graph as soon as it is laid out.
  void showChart(ChartPlan plan);
  /// Sets the brightness of nodes and arrows, from 0 to 1 each, by their indices in the plan;
  /// missing ones are dark.
  void light(std::vector<double> nodes, std::vector<double> edges);
  void select(std::optional<int> node);
  const ChartPlan& plan() const { return plan_; }
  /// The rectangle of a node in the widget (pixels); empty if it is not laid out yet.
  std::optional<QRectF> placeOf(int node) const;

  std::function<void(int node)> clicked;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent*) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;

 private:
  struct Placed {
    QSizeF size{1, 1};
    std::vector<QRectF> nodes;
    struct Arrow {
      QPainterPath path;
      QPointF end, before;  ///< Its last point, and the one before: its direction.
    };
    std::vector<Arrow> edges;
  };

  static Result<Placed> place(const ChartPlan& plan, const std::vector<QSizeF>& sizes);
  static void readEdge(const ChartPlan& plan, const std::vector<std::string>& words,
                       std::vector<bool>& known, Placed& placed);
  QTransform toWidget() const;
  std::optional<int> nodeAt(const QPointF& at) const;
  void paintNode(QPainter& painter, std::size_t node) const;
  void paintEdge(QPainter& painter, std::size_t edge) const;

  ChartPlan plan_, next_;
  std::optional<ChartPlan> waiting_;  ///< The next plan, which waits for being laid out.
  Placed placed_;
  QString fault_;
  std::vector<double> nodeLights_, edgeLights_;
  std::optional<int> selected_;
  double zoom_ = 1;
  QPointF moved_;
  std::optional<QPointF> drag_;
  bool wasDragged_ = false;
  Background placing_;
};

}  // namespace gt
