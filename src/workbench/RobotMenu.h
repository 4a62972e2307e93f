#pragma once
#include <QActionGroup>
#include <QMenu>
#include <functional>
#include <string>

#include "workbench/SessionThread.h"

namespace gt {

/// Adds a part to a context menu to choose the robot that a viewer always shows; empty: the
/// connected one.
inline void addRobotMenu(QMenu& menu, const SessionThread& session, const std::string& chosen,
                         const std::function<void(const std::string& robot)>& choose) {
  QMenu* robots = menu.addMenu("Robot");
  auto* group = new QActionGroup{robots};
  const auto add = [&](const QString& text, const std::string& name) {
    QAction* action = robots->addAction(text, robots, [choose, name] { choose(name); });
    action->setCheckable(true);
    action->setChecked(name == chosen);
    action->setActionGroup(group);
  };
  add("The connected one", {});
  for (const RobotInfo& known : session.status().robots)
    add(QString::fromStdString(known.name), known.name);
}

}  // namespace gt
