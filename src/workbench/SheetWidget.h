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

/// Shows a sheet as large as possible. The wheel zooms to the pointer, dragging moves the sheet, a
/// double click shows the whole again; Ctrl+C and the context menu copy it.
class SheetWidget : public QWidget {
 public:
  explicit SheetWidget(QWidget* parent = nullptr);

  void showSheet(std::shared_ptr<const Sheet> sheet);
  /// Shows a text instead of a sheet, such as the reason why there is none.
  void showText(const QString& text);
  /// Shows sheets as pages of text: from their top on, fitted to the width but large enough to be
  /// read. The wheel and dragging scroll pages that do not fit; the wheel zooms with Ctrl.
  void showPages() { pages_ = true; }
  const Sheet* sheet() const { return sheet_.get(); }
  /// Whether the sheet was set, and is not painted yet although it is visible.
  bool waitsForPainting() const { return unpainted_ && !visibleRegion().isEmpty(); }
  /// Called after each painting.
  std::function<void()> painted;
  const QString& text() const { return text_; }

  /// Returns the text beside the pointer for a place on the sheet; empty: none.
  std::function<QString(const QPointF&)> placeText;
  /// Adds to the context menu of a place on the sheet, before its general part.
  std::function<void(QMenu&, const QPointF&)> addActions;
  /// If set, called with the pixels by which the mouse is dragged, instead of moving the sheet.
  std::function<void(const QPointF&)> dragged;
  /// If set, called with the steps by which the wheel is turned, instead of zooming.
  std::function<void(double)> wheeled;

  /// If set, called with a place on the sheet that is clicked with the left or right button,
  /// instead of dragging and of the context menu.
  std::function<void(const QPointF&, Qt::MouseButton)> clicked;

  /// If set, called when the mouse is dragged with the left button from a place of the sheet to
  /// another, instead of moving the sheet; `done` when the button is released.
  std::function<void(const QPointF& from, const QPointF& to, bool done)> drawn;

  void copyImage() const;
  void copyVectors() const;
  QImage image(double scale) const;

  QSize sizeHint() const override;
  /// The place on the sheet of a point of the widget (pixels).
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
