#include "network/Frame.h"

#include <cstring>

namespace gt {
namespace {

constexpr std::array magic{std::byte{'G'}, std::byte{'T'}, std::byte{2}};

}  // namespace

std::array<std::byte, Frame::headerSize> frameHeader(const Frame& frame) {
  std::array<std::byte, Frame::headerSize> header{magic[0], magic[1], magic[2],
                                                  static_cast<std::byte>(frame.kind)};
  std::memcpy(&header[4], &frame.type, 4);
  std::memcpy(&header[8], &frame.session, 8);
  std::memcpy(&header[16], &frame.time.ms, 8);
  std::memcpy(&header[24], &frame.schema, 4);
  std::memcpy(&header[28], &frame.receiver, 4);
  return header;
}

Result<Frame> parseFrame(std::span<const std::byte> message) {
  if (message.size() < Frame::headerSize ||
      std::memcmp(message.data(), magic.data(), magic.size()) != 0)
    return Error{.file = "network",
                 .field = "frame",
                 .what = "is none of this system's, or of another version"};
  Frame frame;
  frame.kind = static_cast<FrameKind>(message[3]);
  if (frame.kind > FrameKind::describe)
    return Error{.file = "network", .field = "frame", .what = "is of an unknown kind"};
  std::memcpy(&frame.type, &message[4], 4);
  std::memcpy(&frame.session, &message[8], 8);
  std::memcpy(&frame.time.ms, &message[16], 8);
  // A clock beyond a hundred years would only serve to overflow somebody's arithmetic.
  constexpr std::int64_t most = std::int64_t{100} * 366 * 86'400'000;
  if (frame.time.ms > most || frame.time.ms < -most)
    return Error{.file = "network", .field = "frame", .what = "has an impossible time"};
  std::memcpy(&frame.schema, &message[24], 4);
  std::memcpy(&frame.receiver, &message[28], 4);
  frame.bytes = message.subspan(Frame::headerSize);
  return frame;
}

}  // namespace gt
