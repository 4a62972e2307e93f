#include "network/Endpoint.h"

#include "base/Number.h"

namespace gt {

Result<Endpoint> parseEndpoint(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  const auto port = numberFrom<std::uint16_t>(colon == text.npos ? text : text.substr(colon + 1));
  if (!port || colon == 0)
    return Error{.field = std::string{text}, .what = "expected a port, or ADDRESS:PORT"};
  Endpoint endpoint{.port = *port};
  if (colon == text.npos) return endpoint;
  std::string_view address = text.substr(0, colon);
  if (address.size() > 2 && address.front() == '[' && address.back() == ']')
    address = address.substr(1, address.size() - 2);
  endpoint.address = address;
  return endpoint;
}

}  // namespace gt
