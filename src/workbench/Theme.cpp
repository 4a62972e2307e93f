#include "workbench/Theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

namespace gt {
namespace {

QPalette lightPalette() {
  QPalette palette{QColor{240, 240, 242}};
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::AlternateBase, QColor{246, 247, 249});
  palette.setColor(QPalette::Highlight, QColor{38, 110, 190});
  palette.setColor(QPalette::Link, QColor{20, 90, 170});
  palette.setColor(QPalette::ToolTipBase, QColor{255, 255, 225});
  palette.setColor(QPalette::ToolTipText, Qt::black);
  return palette;
}

QPalette darkPalette() {
  const QColor text{222, 222, 226}, faint{125, 125, 132};
  QPalette palette{QColor{45, 46, 50}};
  palette.setColor(QPalette::Window, QColor{45, 46, 50});
  palette.setColor(QPalette::Base, QColor{30, 31, 34});
  palette.setColor(QPalette::AlternateBase, QColor{37, 38, 42});
  palette.setColor(QPalette::Button, QColor{58, 60, 65});
  palette.setColor(QPalette::ToolTipBase, QColor{70, 72, 78});
  palette.setColor(QPalette::Highlight, QColor{55, 125, 205});
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, QColor{110, 175, 245});
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                          QPalette::ToolTipText, QPalette::BrightText})
    palette.setColor(role, text);
  palette.setColor(QPalette::PlaceholderText, faint);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, faint);
  return palette;
}

/// Fusion, with check boxes that can be seen on a dark window, where it gives them a darker frame.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle{"Fusion"} {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    constexpr int middle = 128;
    const bool box = element == PE_IndicatorCheckBox || element == PE_IndicatorItemViewItemCheck;
    if (!box || option->palette.color(QPalette::Window).lightness() >= middle) return;
    painter->save();
    painter->setBrush(Qt::NoBrush);
    painter->setPen(option->palette.color(QPalette::Disabled, QPalette::Text));
    painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
    painter->restore();
  }
};

}  // namespace

void setTheme(Theme theme) {
  QApplication::setStyle(new Style);
  QApplication::setPalette(theme == Theme::dark ? darkPalette() : lightPalette());
}

}  // namespace gt
