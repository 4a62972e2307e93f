#pragma once
#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace gt {

/// Something that is lost when a dialog or the window is closed, unless it is saved.
struct Unsaved {
  QString what;                ///< In words, such as: the color table.
  std::function<bool()> save;  ///< Asks where if it must. Returns whether it was saved.
};

/// Asks whether to save what is not, to discard it, or to cancel. Returns whether it may be lost
/// now; always true if there is nothing to save.
bool mayDiscard(QWidget* parent, const std::vector<Unsaved>& unsaved);

}  // namespace gt
