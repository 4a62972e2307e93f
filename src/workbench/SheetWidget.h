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
  const Sheet* sheet() const { return sheet_.get(); }
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
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double scale() const;
  QPointF corner() const;

  std::shared_ptr<const Sheet> sheet_;
  QString text_;
  double zoom_ = 1;
  QPointF moved_;
  std::optional<QPointF> drag_;
};

}  // namespace gt
