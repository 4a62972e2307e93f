#include "images/Png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>

namespace gt {
namespace {

TEST(Png, KeepsTheImage) {
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < 5 * 3 * 3; ++i) rgb.push_back(static_cast<std::uint8_t>(5 * i));
  const auto png = encodePng(5, 3, rgb);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, png.data(), png.size()), 0);
  EXPECT_EQ(image.width, 5u);
  EXPECT_EQ(image.height, 3u);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, rgb);
}

TEST(Png, IsWrittenToAFile) {
  const std::vector<std::uint8_t> rgb(5 * 3 * 3, 128);
  const std::string path = testing::TempDir() + "Png_test.png";
  EXPECT_TRUE(writePng(path, 5, 3, rgb));
  EXPECT_FALSE(writePng("/nowhere/a.png", 5, 3, rgb));
  std::remove(path.c_str());
}

}  // namespace
}  // namespace gt
