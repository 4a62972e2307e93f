#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/Result.h"

namespace gt {

/// The address and port on which a program listens, or to which it connects, by TCP or UDP.
struct Endpoint {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: listen on any free port.
};

/// Parses PORT, on the loopback device, or ADDRESS:PORT; an address of IPv6 is in brackets. The
/// validity of the address is not checked.
Result<Endpoint> parseEndpoint(std::string_view text);

}  // namespace gt
