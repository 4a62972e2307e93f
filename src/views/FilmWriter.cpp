#include "views/FilmWriter.h"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "base/OutputLock.h"
#include "base/UnfinishedFile.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

namespace gt {
namespace {

std::string reason(int code) {
  char text[AV_ERROR_MAX_STRING_SIZE];
  av_strerror(code, text, sizeof text);
  return text;
}

}  // namespace

struct FilmWriter::State {
  std::string file;
  std::optional<UnfinishedFile> unfinished;
  std::optional<OutputLock> lock;
  AVFormatContext* format = nullptr;
  AVCodecContext* codec = nullptr;
  AVStream* stream = nullptr;
  AVFrame* frame = nullptr;
  AVPacket* packet = nullptr;
  SwsContext* converter = nullptr;
  std::int64_t pictures = 0;
  bool open = false;

  ~State() {
    sws_freeContext(converter);
    av_packet_free(&packet);
    av_frame_free(&frame);
    avcodec_free_context(&codec);
    if (format && format->pb) avio_closep(&format->pb);
    avformat_free_context(format);
  }
  Error error(const std::string& what, int code) const {
    return {.file = file, .what = what + ": " + reason(code)};
  }
  Result<void> openCodec(int width, int height);
  Result<void> openFile();
  /// Encodes a frame, or with null what is still in the encoder.
  Result<void> encode(const AVFrame* picture);
};

Result<void> FilmWriter::State::openCodec(int width, int height) {
  const AVCodec* encoder = avcodec_find_encoder_by_name("libx264");
  if (!encoder) encoder = avcodec_find_encoder(AV_CODEC_ID_MPEG4);
  codec = encoder ? avcodec_alloc_context3(encoder) : nullptr;
  frame = av_frame_alloc();
  packet = av_packet_alloc();
  if (!codec || !frame || !packet)
    return Error{.file = file, .what = "there is no encoder for films"};
  codec->width = frame->width = width;
  codec->height = frame->height = height;
  codec->pix_fmt = AV_PIX_FMT_YUV420P;
  frame->format = AV_PIX_FMT_YUV420P;
  codec->time_base = {1, imagesPerSecond};
  codec->framerate = {imagesPerSecond, 1};
  codec->gop_size = 2 * imagesPerSecond;
  codec->bit_rate = 3'000'000;
  codec->thread_count = 1;
  if (format->oformat->flags & AVFMT_GLOBALHEADER) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  av_opt_set(codec->priv_data, "preset", "veryfast", 0);
  if (const int code = avcodec_open2(codec, encoder, nullptr); code < 0)
    return error("the encoder cannot be opened", code);
  if (const int code = av_frame_get_buffer(frame, 0); code < 0) return error("no memory", code);
  converter = sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, AV_PIX_FMT_YUV420P,
                             SWS_BILINEAR, nullptr, nullptr, nullptr);
  return converter ? Result<void>{} : Error{.file = file, .what = "no conversion of colors"};
}

Result<void> FilmWriter::State::openFile() {
  stream = avformat_new_stream(format, nullptr);
  if (!stream) return Error{.file = file, .what = "no memory"};
  stream->time_base = codec->time_base;
  avcodec_parameters_from_context(stream->codecpar, codec);
  const std::string written = unfinishedName(file);
  auto locked = OutputLock::ofFile(written);
  if (!locked) return Error{.file = file, .what = locked.error().what};
  lock = std::move(*locked);
  unfinished.emplace(file);
  if (const int code = avio_open(&format->pb, written.c_str(), AVIO_FLAG_WRITE); code < 0)
    return error("cannot be written", code);
  open = true;
  if (const int code = avformat_write_header(format, nullptr); code < 0)
    return error("cannot be written", code);
  return {};
}

Result<void> FilmWriter::State::encode(const AVFrame* picture) {
  int code = avcodec_send_frame(codec, picture);
  while (code >= 0) {
    code = avcodec_receive_packet(codec, packet);
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return {};
    if (code < 0) break;
    av_packet_rescale_ts(packet, codec->time_base, stream->time_base);
    packet->stream_index = stream->index;
    code = av_interleaved_write_frame(format, packet);
  }
  return error("cannot be written", code);
}

FilmWriter::FilmWriter(std::unique_ptr<State> state) : state_{std::move(state)} {}

FilmWriter::~FilmWriter() {
  static_cast<void>(close());
}

Result<std::unique_ptr<FilmWriter>> FilmWriter::open(const std::string& file, int width,
                                                     int height) {
  std::error_code ignored;  // then opening the file reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  av_log_set_level(AV_LOG_ERROR);
  auto state = std::make_unique<State>();
  state->file = file;
  if (const int code = avformat_alloc_output_context2(&state->format, nullptr, "mp4", file.c_str());
      code < 0)
    return state->error("cannot be written", code);
  if (auto done = state->openCodec((width + 1) / 2 * 2, (height + 1) / 2 * 2); !done)
    return done.error();
  if (auto done = state->openFile(); !done) return done.error();
  return std::unique_ptr<FilmWriter>{new FilmWriter{std::move(state)}};
}

Result<void> FilmWriter::add(const RgbImage& picture) {
  const int width = state_->codec->width, height = state_->codec->height;
  std::vector<std::uint8_t> rgb(3u * static_cast<std::size_t>(width) *
                                static_cast<std::size_t>(height));
  for (int y = 0; y < std::min(height, picture.height); ++y)
    std::copy_n(picture.pixels.data() + 3 * y * picture.width, 3 * std::min(width, picture.width),
                rgb.data() + 3 * y * width);
  if (const int code = av_frame_make_writable(state_->frame); code < 0)
    return state_->error("no memory", code);
  const std::uint8_t* from[] = {rgb.data()};
  const int stride[] = {3 * width};
  sws_scale(state_->converter, from, stride, 0, height, state_->frame->data,
            state_->frame->linesize);
  state_->frame->pts = state_->pictures++;
  return state_->encode(state_->frame);
}

Result<void> FilmWriter::close() {
  if (!state_ || !state_->open) return {};
  auto done = state_->encode(nullptr);
  if (const int code = av_write_trailer(state_->format); code < 0 && done)
    done = state_->error("cannot be written", code);
  if (const int code = avio_closep(&state_->format->pb); code < 0 && done)
    done = state_->error("cannot be written", code);
  if (done) done = state_->unfinished->finish();
  state_.reset();
  return done;
}

}  // namespace gt
