#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/Result.h"
#include "base/Time.h"

namespace gt {

/// The purpose of a frame (report C.3). accept: the receiver accepts a package, even if it has not
/// taken the last one; request: the receiver has taken the last package and requests a new one;
/// package: a package; describe: the receiver asks for the schema of a type's packages.
enum class FrameKind : std::uint8_t { accept, request, package, describe };

/// One message between two processes on a wire: a header of 32 bytes, followed by the package as
/// CDR, or by an unchanged message queue.
struct Frame {
  static constexpr std::size_t headerSize = 32;

  FrameKind kind = FrameKind::accept;
  std::uint32_t type = 0;     ///< Id of the representation.
  std::uint64_t session = 0;  ///< Session of the sending program; differs after a restart.
  Time time;                  ///< Time by the sender's clock.
  std::span<const std::byte> bytes{};
  std::uint32_t schema = 0;    ///< Id of the type's schema, as the sender knows it.
  std::uint32_t receiver = 0;  ///< Number among the process's receivers of that type.
};

/// Encodes the header: "GT", the version 2, the kind, and the numbers, little endian.
std::array<std::byte, Frame::headerSize> frameHeader(const Frame& frame);
/// Decodes a frame. Its bytes refer to the message. Returns an error if it is not a frame.
Result<Frame> parseFrame(std::span<const std::byte> message);

}  // namespace gt
