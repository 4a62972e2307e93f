#include "workbench/SaveImage.h"

#include <QFileInfo>

#include "base/UnfinishedFile.h"

namespace gt {

Result<void> saveWhole(const QString& file, const std::function<bool(const QString&)>& save) {
  UnfinishedFile unfinished{file.toStdString()};
  if (save(QString::fromStdString(unfinished.written()))) return unfinished.finish();
  return Error{.file = unfinished.path(), .what = "cannot be written"};
}

Result<void> saveImage(const QImage& image, const QString& file) {
  const QByteArray format = QFileInfo{file}.suffix().toLatin1();
  return saveWhole(file, [&](const QString& written) {
    return image.save(written, format.isEmpty() ? "png" : format.constData());
  });
}

}  // namespace gt
