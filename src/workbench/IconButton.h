#pragma once
#include <QEvent>
#include <QLayout>
#include <QPainter>
#include <QStyle>
#include <QToolButton>

namespace gt {

/// A button with an icon of the style in the color of its text, so that it can be seen in light and
/// in dark windows.
class IconButton : public QToolButton {
 public:
  IconButton(const QString& name, QStyle::StandardPixmap which, const QString& help) {
    setObjectName(name);
    setToolTip(help);
    setAutoRaise(true);
    showIcon(which);
  }
  void showIcon(QStyle::StandardPixmap which) {
    if (which == which_ && !icon().isNull()) return;
    which_ = which;
    paint();
  }

 protected:
  void changeEvent(QEvent* event) override {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) paint();
  }

 private:
  void paint() {
    constexpr int size = 32;
    QPixmap pixmap = style()->standardIcon(which_).pixmap(size, size);
    QPainter painter{&pixmap};
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(pixmap.rect(), palette().color(QPalette::ButtonText));
    painter.end();
    setIcon(QIcon{pixmap});
  }

  QStyle::StandardPixmap which_{};
};

/// Adds a button to a toolbar, which calls `pressed` as long as `owner` exists.
template <typename Pressed>
IconButton* addIconButton(QLayout& toolbar, QObject& owner, const char* name,
                          QStyle::StandardPixmap which, const char* help, Pressed pressed) {
  auto* made = new IconButton{name, which, help};
  QObject::connect(made, &QToolButton::clicked, &owner, pressed);
  toolbar.addWidget(made);
  return made;
}

}  // namespace gt
