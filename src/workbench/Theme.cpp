#include "workbench/Theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

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

}  // namespace

void setTheme(Theme theme) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  QApplication::setPalette(theme == Theme::dark ? darkPalette() : lightPalette());
}

}  // namespace gt
