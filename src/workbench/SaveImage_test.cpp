#include "workbench/SaveImage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"

namespace gt {
namespace {

TEST(SaveImage, WritesAnImageWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "image.png").string();
  ASSERT_TRUE(writeFile(file, "what was there"));
  const auto failed = saveWhole(QString::fromStdString(file), [&](const QString& written) {
    EXPECT_TRUE(writeFile(written.toStdString(), "half"));
    return false;
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().text(), file + ": cannot be written");
  EXPECT_EQ(*readFile(file), "what was there");
  QImage image{3, 2, QImage::Format_RGB32};
  image.fill(Qt::red);
  ASSERT_TRUE(saveImage(image, QString::fromStdString(file)));
  EXPECT_EQ(QImage{QString::fromStdString(file)}, image);
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  EXPECT_FALSE(saveImage(image, QString::fromStdString(file + ".unknown")));
  EXPECT_FALSE(std::filesystem::exists(file + ".unknown"));
}

}  // namespace
}  // namespace gt
