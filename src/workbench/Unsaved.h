#pragma once
#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace gt {

/// Something that is lost when a dialog or the window is closed, unless it is saved.
struct Unsaved {
  QString what;                ///< In words, such as: the color table.
  std::function<bool()> save;  ///< Asks for a file if necessary. Returns whether it was saved.
};

/// Asks whether to save unsaved changes, to discard them, or to cancel. Returns true if they were
/// saved or discarded, or if there are none.
bool mayDiscard(QWidget* parent, const std::vector<Unsaved>& unsaved);

}  // namespace gt
