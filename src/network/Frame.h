#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/Result.h"
#include "base/Time.h"

namespace gt {

/// What a frame is for (report C.3): a receiver accepts a package, even if it has not taken the
/// last one; it requests a package, having taken the last one; a package.
enum class FrameKind : std::uint8_t { accept, request, package };

/// One message between two processes on a wire: 24 bytes of header, then the package as CDR, or a
/// message queue as it is.
struct Frame {
  static constexpr std::size_t headerSize = 24;

  FrameKind kind = FrameKind::accept;
  std::uint32_t type = 0;     ///< The representation's id.
  std::uint64_t session = 0;  ///< Of the sending program; another one after a restart.
  Time time;                  ///< By the sender's clock.
  std::span<const std::byte> bytes;
};

/// The header as bytes: "GT", the version 1, the kind, and the numbers, little endian.
std::array<std::byte, Frame::headerSize> frameHeader(const Frame& frame);
/// A frame whose bytes lie in the message; an error if it is none.
Result<Frame> parseFrame(std::span<const std::byte> message);

}  // namespace gt
