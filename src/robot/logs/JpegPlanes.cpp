#include "robot/logs/JpegPlanes.h"

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

namespace gt {
namespace {

/// libjpeg's way out of an error is a jump.
struct ErrorManager {
  jpeg_error_mgr base;
  std::jmp_buf exit;
  char message[JMSG_LENGTH_MAX];
};

void onError(j_common_ptr info) {
  auto* manager = reinterpret_cast<ErrorManager*>(info->err);
  info->err->format_message(info, manager->message);
  std::longjmp(manager->exit, 1);
}

// No object with a destructor may live here, since errors jump out.
bool decode(jpeg_decompress_struct& info, ErrorManager& errors, std::string_view bytes,
            JpegPlanes& planes) {
  if (setjmp(errors.exit)) return false;
  jpeg_mem_src(&info, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&info, TRUE);
  if (info.image_width > 4096 || info.image_height > 4096 || info.num_components > 4) {
    std::snprintf(errors.message, sizeof errors.message, "the JPEG picture is too large");
    return false;
  }
  info.jpeg_color_space = JCS_UNKNOWN;
  info.out_color_space = JCS_UNKNOWN;
  jpeg_start_decompress(&info);
  planes.width = static_cast<int>(info.output_width);
  planes.height = static_cast<int>(info.output_height);
  planes.channels = info.output_components;
  const std::size_t stride = std::size_t{info.output_width} *
                             static_cast<std::size_t>(info.output_components);
  planes.samples.resize(stride * info.output_height);
  while (info.output_scanline < info.output_height) {
    JSAMPROW row = planes.samples.data() + stride * info.output_scanline;
    jpeg_read_scanlines(&info, &row, 1);
  }
  if (errors.base.num_warnings > 0) {
    errors.base.format_message(reinterpret_cast<j_common_ptr>(&info), errors.message);
    return false;
  }
  return true;
}

}  // namespace

Result<JpegPlanes> decodeJpegPlanes(std::string_view bytes) {
  jpeg_decompress_struct info{};
  ErrorManager errors{};
  info.err = jpeg_std_error(&errors.base);
  errors.base.error_exit = onError;
  errors.base.emit_message = [](j_common_ptr i, int level) {
    if (level < 0) ++i->err->num_warnings;
  };
  JpegPlanes planes;
  jpeg_create_decompress(&info);
  const bool ok = decode(info, errors, bytes, planes);
  jpeg_destroy_decompress(&info);
  if (!ok) return Error{"", 0, "", std::string{"JPEG: "} + errors.message};
  return planes;
}

}  // namespace gt
