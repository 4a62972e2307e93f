#include "images/Jpeg.h"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
// jpeglib.h needs std::size_t and FILE to be known.
#include <jpeglib.h>

namespace gt {
namespace {

constexpr std::int64_t mostPixels = 1 << 26;

/// libjpeg's error handler, made to jump back to where it was called.
struct ErrorManager {
  jpeg_error_mgr base{};
  std::jmp_buf back;
  char message[JMSG_LENGTH_MAX] = "";
};

[[noreturn]] void onError(j_common_ptr info) {
  auto* manager = reinterpret_cast<ErrorManager*>(info->err);
  info->err->format_message(info, manager->message);
  std::longjmp(manager->back, 1);
}

jpeg_error_mgr* prepare(ErrorManager& manager) {
  jpeg_std_error(&manager.base);
  manager.base.error_exit = onError;
  manager.base.output_message = [](j_common_ptr) {};
  return &manager.base;
}

/// Everything that may jump is in functions without objects that would have to be destroyed.
bool start(jpeg_decompress_struct& info, ErrorManager& manager,
           std::span<const std::uint8_t> bytes) {
  if (setjmp(manager.back) != 0) return false;
  jpeg_mem_src(&info, bytes.data(), bytes.size());
  jpeg_read_header(&info, TRUE);
  info.out_color_space = info.jpeg_color_space;
  info.dct_method = JDCT_ISLOW;
  jpeg_calc_output_dimensions(&info);
  return true;
}

bool readRows(jpeg_decompress_struct& info, ErrorManager& manager, std::uint8_t* to) {
  if (setjmp(manager.back) != 0) return false;
  jpeg_start_decompress(&info);
  const std::size_t rowSize = static_cast<std::size_t>(info.output_width) *
                              static_cast<std::size_t>(info.output_components);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = to + rowSize * info.output_scanline;
    jpeg_read_scanlines(&info, &row, 1);
  }
  jpeg_finish_decompress(&info);
  return true;
}

void copyRow(const std::uint8_t* pixels, const jpeg_compress_struct& info, int pixelStride,
             std::uint8_t* row) {
  const auto stride = static_cast<std::size_t>(pixelStride);
  const std::uint8_t* from = pixels + stride * info.image_width * info.next_scanline;
  for (JDIMENSION x = 0; x < info.image_width; ++x, from += stride)
    for (int c = 0; c < 3; ++c) *row++ = from[c];
}

bool writeRows(jpeg_compress_struct& info, ErrorManager& manager, const std::uint8_t* pixels,
               int pixelStride, int quality, std::uint8_t* row, unsigned char** out,
               unsigned long* size) {
  if (setjmp(manager.back) != 0) return false;
  jpeg_mem_dest(&info, out, size);
  jpeg_set_defaults(&info);
  jpeg_set_colorspace(&info, JCS_YCbCr);
  jpeg_set_quality(&info, quality, TRUE);
  for (int i = 0; i < 3; ++i) info.comp_info[i].h_samp_factor = info.comp_info[i].v_samp_factor = 1;
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    copyRow(pixels, info, pixelStride, row);
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  return true;
}

}  // namespace

std::vector<std::uint8_t> encodeJpeg(const std::uint8_t* pixels, int width, int height,
                                     int pixelStride, int quality) {
  assert(width > 0 && height > 0 && width <= 65500 && height <= 65500);
  ErrorManager manager;
  jpeg_compress_struct info{};
  info.err = prepare(manager);
  jpeg_create_compress(&info);
  info.image_width = static_cast<JDIMENSION>(width);
  info.image_height = static_cast<JDIMENSION>(height);
  info.input_components = 3;
  info.in_color_space = JCS_YCbCr;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width) * 3);
  unsigned char* packed = nullptr;
  unsigned long size = 0;
  const bool good =
      writeRows(info, manager, pixels, pixelStride, quality, row.data(), &packed, &size);
  std::vector<std::uint8_t> out;
  if (good) out.assign(packed, packed + size);
  jpeg_destroy_compress(&info);
  std::free(packed);
  return out;
}

Result<RawImage> decodeJpeg(std::span<const std::uint8_t> bytes) {
  ErrorManager manager;
  jpeg_decompress_struct info{};
  info.err = prepare(manager);
  jpeg_create_decompress(&info);
  RawImage picture;
  bool good = start(info, manager, bytes);
  if (good && std::int64_t{info.output_width} * info.output_height > mostPixels) {
    good = false;
    std::snprintf(manager.message, sizeof manager.message, "more than 2^26 pixels");
  }
  if (good) {
    picture.width = static_cast<int>(info.output_width);
    picture.height = static_cast<int>(info.output_height);
    picture.components = info.num_components;
    picture.data.resize(static_cast<std::size_t>(info.output_width) * info.output_height *
                        static_cast<std::size_t>(info.num_components));
    good = readRows(info, manager, picture.data.data());
  }
  // An image that was cut off is only a warning to libjpeg.
  if (good && manager.base.num_warnings > 0) {
    good = false;
    manager.base.format_message(reinterpret_cast<j_common_ptr>(&info), manager.message);
  }
  jpeg_destroy_decompress(&info);
  if (!good) return Error{.what = std::string("no sound JPEG image: ") + manager.message};
  return picture;
}

}  // namespace gt
