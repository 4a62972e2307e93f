#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/Result.h"
#include "base/Time.h"

namespace gt {

/// What a frame is for (report C.3): a receiver accepts a package, even if it has not taken the
/// last one; it requests a package, having taken the last one; a package; a receiver asks for the
/// schema by which packages of a type are written.
enum class FrameKind : std::uint8_t { accept, request, package, describe };

/// One message between two processes on a wire: 32 bytes of header, then the package as CDR, or a
/// message queue as it is.
struct Frame {
  static constexpr std::size_t headerSize = 32;

  FrameKind kind = FrameKind::accept;
  std::uint32_t type = 0;     ///< The representation's id.
  std::uint64_t session = 0;  ///< Of the sending program; another one after a restart.
  Time time;                  ///< By the sender's clock.
  std::span<const std::byte> bytes{};
  std::uint32_t schema = 0;    ///< The id of the type's schema, as the sender knows it.
  std::uint32_t receiver = 0;  ///< Which of the process's receivers of that type.
};

/// The header as bytes: "GT", the version 2, the kind, and the numbers, little endian.
std::array<std::byte, Frame::headerSize> frameHeader(const Frame& frame);
/// A frame whose bytes lie in the message; an error if it is none.
Result<Frame> parseFrame(std::span<const std::byte> message);

}  // namespace gt
