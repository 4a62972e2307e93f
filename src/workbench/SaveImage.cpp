#include "workbench/SaveImage.h"

#include <QFile>
#include <QFileInfo>

#include "streams/File.h"

namespace gt {

Result<void> saveWhole(const QString& file, const std::function<bool(const QString&)>& save) {
  const std::string path = file.toStdString(), written = unfinishedName(path);
  if (save(QString::fromStdString(written))) return finishFile(path, written);
  if (written != path) QFile::remove(QString::fromStdString(written));
  return Error{.file = path, .what = "cannot be written"};
}

Result<void> saveImage(const QImage& image, const QString& file) {
  const QByteArray format = QFileInfo{file}.suffix().toLatin1();
  return saveWhole(file, [&](const QString& written) {
    return image.save(written, format.isEmpty() ? "png" : format.constData());
  });
}

}  // namespace gt
