#pragma once
#include <QColor>

namespace gt {

/// How the workbench looks.
enum class Theme { light, dark };

/// Gives all windows the look.
void setTheme(Theme theme);

}  // namespace gt
