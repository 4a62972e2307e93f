#pragma once
#include <QLayout>
#include <QPushButton>

namespace gt {

/// Adds a button with a text to a dialog, which calls `pressed` as long as `owner` exists.
template <typename Pressed>
void addPushButton(QLayout& row, QObject& owner, const char* name, const char* text,
                   const char* help, Pressed pressed) {
  auto* made = new QPushButton{text};
  made->setObjectName(name);
  made->setToolTip(help);
  QObject::connect(made, &QPushButton::clicked, &owner, pressed);
  row.addWidget(made);
}

}  // namespace gt
