#include "images/Png.h"

#include <png.h>

#include <cassert>

#include "base/File.h"

namespace gt {

std::vector<std::uint8_t> encodePng(int width, int height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> out(PNG_IMAGE_PNG_SIZE_MAX(image));
  png_alloc_size_t size = out.size();
  if (png_image_write_to_memory(&image, out.data(), &size, 0, rgb.data(), 0, nullptr) == 0)
    size = 0;
  out.resize(size);
  return out;
}

Result<void> writePng(const std::string& path, int width, int height,
                      std::span<const std::uint8_t> rgb) {
  const auto png = encodePng(width, height, rgb);
  if (png.empty()) return Error{.file = path, .what = "the image cannot be packed as PNG"};
  return writeFile(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace gt
