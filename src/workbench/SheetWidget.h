#pragma once
#include <QPointF>
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>

#include "views/painting/Sheet.h"

class QMenu;

namespace gt {

/// Shows a sheet as large as there is room. The wheel zooms to where the pointer is, dragging moves
/// it, a double click shows the whole again; Ctrl+C and the context menu copy it.
class SheetWidget : public QWidget {
 public:
  explicit SheetWidget(QWidget* parent = nullptr);

  void showSheet(std::shared_ptr<const Sheet> sheet);
  /// Shows a text instead, such as why there is no sheet.
  void showText(const QString& text);
  /// Shows sheets as pages of text: from their top on, as wide as there is room but large enough to
  /// be read. The wheel and dragging move what does not fit; the wheel zooms with Ctrl.
  void showPages() { pages_ = true; }
  const Sheet* sheet() const { return sheet_.get(); }
  /// Whether the sheet was given, and is not painted yet although it can be seen.
  bool waitsForPainting() const { return unpainted_ && !visibleRegion().isEmpty(); }
  /// Called after each painting.
  std::function<void()> painted;
  const QString& text() const { return text_; }

  /// The text beside the pointer for a place on the sheet; empty: none.
  std::function<QString(const QPointF&)> placeText;
  /// Adds to the context menu of a place on the sheet, before its general part.
  std::function<void(QMenu&, const QPointF&)> addActions;
  /// Dragging by so many pixels, instead of moving the sheet.
  std::function<void(const QPointF&)> dragged;
  /// Turning the wheel by so many steps, instead of zooming.
  std::function<void(double)> wheeled;

  /// Clicking on a place of the sheet with the left or right button, instead of dragging and of the
  /// context menu.
  std::function<void(const QPointF&, Qt::MouseButton)> clicked;

  /// Dragging with the left button from a place of the sheet to another, instead of moving the
  /// sheet; `done` when the button is let go.
  std::function<void(const QPointF& from, const QPointF& to, bool done)> drawn;

  void copyImage() const;
  void copyVectors() const;
  QImage image(double scale) const;

  QSize sizeHint() const override;
  /// Where a point of the widget lies on the sheet.
  QPointF toSheet(const QPointF& point) const;

 protected:
  void paintEvent(QPaintEvent*) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double scale() const;
  QPointF corner() const;

  std::shared_ptr<const Sheet> sheet_;
  QString text_;
  bool unpainted_ = false;
  bool pages_ = false;
  double zoom_ = 1;
  QPointF moved_;
  std::optional<QPointF> drag_;
  std::optional<QPointF> drawnFrom_;  ///< On the sheet.
};

}  // namespace gt
