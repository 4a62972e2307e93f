#pragma once
#include <QLayout>
#include <QPushButton>
#include <QString>
#include <utility>

namespace gt {

/// Makes a control of a dialog: a widget of Qt, with what else its constructor takes. Tests and
/// tutorials find it by its name; its help is a sentence, the tooltip.
template <typename Widget, typename... About>
Widget* makeControl(const QString& name, const QString& help, About&&... about) {
  auto* made = new Widget{std::forward<About>(about)...};
  made->setObjectName(name);
  made->setToolTip(help);
  return made;
}

/// Adds a button with a text to a dialog, which calls `pressed` while `owner` lives.
template <typename Button = QPushButton, typename Pressed>
void addButton(QLayout& row, QObject& owner, const QString& name, const QString& text,
               const QString& help, Pressed pressed) {
  auto* made = makeControl<Button>(name, help);
  made->setText(text);
  QObject::connect(made, &Button::clicked, &owner, pressed);
  row.addWidget(made);
}

}  // namespace gt
