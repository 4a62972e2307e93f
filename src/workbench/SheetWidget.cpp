#include "workbench/SheetWidget.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "workbench/QtPainter.h"

namespace gt {
namespace {

constexpr double mostSheetZoom = 40;
constexpr double copyScale = 2;  // of copied images
constexpr double leastPageScale = 0.75, mostPageScale = 1.5;
constexpr double pageStep = 48;  // pixels that a step of the wheel moves a page

}  // namespace

SheetWidget::SheetWidget(QWidget* parent) : QWidget{parent} {
  setMinimumSize(80, 60);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::ClickFocus);
  setMouseTracking(true);
}

void SheetWidget::showSheet(std::shared_ptr<const Sheet> sheet) {
  sheet_ = std::move(sheet);
  unpainted_ = true;
  text_.clear();
  update();
}

void SheetWidget::showText(const QString& text) {
  if (text == text_) return;
  text_ = text;
  update();
}

QSize SheetWidget::sizeHint() const {
  return sheet_ ? QSize{sheet_->width(), sheet_->height()}.boundedTo({640, 480}) : QSize{320, 240};
}

double SheetWidget::scale() const {
  if (!sheet_) return 1;
  if (pages_)
    return zoom_ * std::clamp(static_cast<double>(width()) / sheet_->width(), leastPageScale,
                              mostPageScale);
  return zoom_ * std::min(static_cast<double>(width()) / sheet_->width(),
                          static_cast<double>(height()) / sheet_->height());
}

QPointF SheetWidget::corner() const {
  const QPointF size{scale() * sheet_->width(), scale() * sheet_->height()};
  if (pages_)
    return {std::clamp(moved_.x(), std::min(0.0, width() - size.x()), 0.0),
            std::clamp(moved_.y(), std::min(0.0, height() - size.y()), 0.0)};
  return QPointF{width() - size.x(), height() - size.y()} / 2 + moved_;
}

QPointF SheetWidget::toSheet(const QPointF& point) const {
  return sheet_ ? (point - corner()) / scale() : QPointF{};
}

void SheetWidget::paintEvent(QPaintEvent*) {
  QPainter painter{this};
  if (sheet_) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(corner());
    painter.scale(scale(), scale());
    painter.setClipRect(QRectF{0, 0, 1.0 * sheet_->width(), 1.0 * sheet_->height()});
    QtPainter on{painter};
    sheet_->paintOn(on);
    painter.restore();
  }
  if (!text_.isEmpty()) {
    const QRect place = rect().adjusted(8, 8, -8, -8);
    if (sheet_) painter.fillRect(rect(), QColor{0, 0, 0, 110});
    painter.setPen(sheet_ ? QColor{Qt::white}
                          : palette().color(QPalette::Disabled, QPalette::WindowText));
    painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap, text_);
  }
  unpainted_ = false;
  if (painted) painted();
}

void SheetWidget::wheelEvent(QWheelEvent* event) {
  const double steps = event->angleDelta().y() / 120.0;
  if (wheeled) return wheeled(steps);
  if (!sheet_) return;
  if (pages_ && !event->modifiers().testFlag(Qt::ControlModifier)) {
    moved_ = corner() + QPointF{0, pageStep * steps};
    return update();
  }
  const QPointF place = toSheet(event->position());
  zoom_ = std::clamp(zoom_ * std::pow(1.2, steps), 1.0, mostSheetZoom);
  if (zoom_ == 1) moved_ = {};
  moved_ += event->position() - (place * scale() + corner());
  if (zoom_ == 1) moved_ = {};
  update();
}

void SheetWidget::mousePressEvent(QMouseEvent* event) {
  if (clicked) {
    if (sheet_) clicked(toSheet(event->position()), event->button());
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  if (drawn && sheet_)
    drawnFrom_ = toSheet(event->position());
  else
    drag_ = event->position();
}

void SheetWidget::mouseMoveEvent(QMouseEvent* event) {
  if (drawnFrom_) {
    drawn(*drawnFrom_, toSheet(event->position()), false);
  } else if (drag_) {
    const QPointF by = event->position() - *drag_;
    drag_ = event->position();
    if (dragged) return dragged(by);
    if (!sheet_) return;
    if (pages_)
      moved_ = corner() + by;
    else if (zoom_ > 1)
      moved_ += by;
    update();
  } else if (sheet_ && placeText) {
    QToolTip::showText(event->globalPosition().toPoint(), placeText(toSheet(event->position())),
                       this);
  }
}

void SheetWidget::mouseReleaseEvent(QMouseEvent* event) {
  drag_.reset();
  if (const auto from = std::exchange(drawnFrom_, std::nullopt))
    drawn(*from, toSheet(event->position()), true);
}

void SheetWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (drawn) return mousePressEvent(event);
  zoom_ = 1;
  moved_ = {};
  update();
}

void SheetWidget::contextMenuEvent(QContextMenuEvent* event) {
  if (clicked) return;
  QMenu menu;
  if (addActions) addActions(menu, toSheet(event->pos()));
  menu.addSeparator();
  QAction* copy = menu.addAction("Copy image and drawings", [this] { copyImage(); });
  QAction* vectors = menu.addAction("Copy drawings as vector graphics", [this] { copyVectors(); });
  QAction* save = menu.addAction("Save as…", [this] {
    const QString file =
        QFileDialog::getSaveFileName(this, "Save the view", "view.png", "Images (*.png *.svg)");
    if (file.isEmpty() || !sheet_) return;
    if (const auto done = sheet_->write(file.toStdString()); !done)
      QMessageBox::warning(this, "Save", QString::fromStdString(done.error().text()));
  });
  for (QAction* action : {copy, vectors, save}) action->setEnabled(sheet_ != nullptr);
  menu.exec(event->globalPos());
}

void SheetWidget::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return copyImage();
  QWidget::keyPressEvent(event);
}

QImage SheetWidget::image(double scale) const {
  if (!sheet_) return {};
  QImage image{static_cast<int>(scale * sheet_->width()),
               static_cast<int>(scale * sheet_->height()), QImage::Format_RGB32};
  QPainter painter{&image};
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(scale, scale);
  QtPainter on{painter};
  sheet_->paintOn(on);
  return image;
}

void SheetWidget::copyImage() const {
  if (sheet_) QApplication::clipboard()->setImage(image(copyScale));
}

void SheetWidget::copyVectors() const {
  if (!sheet_) return;
  const QByteArray svg = QByteArray::fromStdString(sheet_->svg());
  auto* copied = new QMimeData;
  copied->setData("image/svg+xml", svg);
  copied->setText(QString::fromUtf8(svg));
  QApplication::clipboard()->setMimeData(copied);
}

}  // namespace gt
