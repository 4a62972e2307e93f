#include "workbench/Application.h"

#include "base/Guarded.h"

namespace gt {

bool Application::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const std::exception& exception) {
    if (!failure_) failure_ = errorOf(exception);
    exit(2);
    return false;
  }
}

}  // namespace gt
