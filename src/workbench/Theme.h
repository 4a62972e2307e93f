#pragma once
#include <QColor>

namespace gt {

/// The color schemes of the workbench.
enum class Theme { light, dark };

/// Applies a color scheme to all windows.
void setTheme(Theme theme);

}  // namespace gt
