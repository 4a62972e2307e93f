#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/Result.h"

namespace gt {

/// Where a program listens, or whom it is connected with: an address and a port of TCP or UDP.
struct Endpoint {
  std::string address = "127.0.0.1";
  std::uint16_t port = 0;  ///< To listen on: 0 is any that is free.
};

/// Reads PORT, on the loopback device, or ADDRESS:PORT; an address of IPv6 stands in brackets.
/// Whether the address is one is not looked at.
Result<Endpoint> parseEndpoint(std::string_view text);

}  // namespace gt
