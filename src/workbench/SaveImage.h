#pragma once
#include <QImage>
#include <QString>
#include <functional>

#include "base/Result.h"

namespace gt {

/// Writes a file, whole or not at all: `save` writes it under the name that is passed and returns
/// whether it succeeded.
Result<void> saveWhole(const QString& file, const std::function<bool(const QString&)>& save);

/// Writes an image in the format that the file's name ends with, whole or not at all.
Result<void> saveImage(const QImage& image, const QString& file);

}  // namespace gt
