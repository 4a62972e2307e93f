#include "workbench/Unsaved.h"

#include <QMessageBox>
#include <QStringList>
#include <algorithm>

namespace gt {

bool mayDiscard(QWidget* parent, const std::vector<Unsaved>& unsaved) {
  if (unsaved.empty()) return true;
  QStringList lines;
  for (const Unsaved& one : unsaved) lines << "• " + one.what;
  switch (QMessageBox::question(parent, "Not saved", "This is not saved:\n\n" + lines.join('\n'),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel)) {
    case QMessageBox::Save:
      return std::ranges::all_of(unsaved, [](const Unsaved& one) { return one.save(); });
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

}  // namespace gt
