#include <span>
#include <tuple>

#include "Fuzz.h"
#include "debug/Drawing.h"
#include "representations/All.h"
#include "streams/Binary.h"
#include "streams/MessageQueue.h"

namespace {

template <typename... T>
struct Decoder {
  static void decodeAll(std::span<const std::byte> bytes) {
    // Static: some are large.
    static std::tuple<T...> values;
    std::apply([&](auto&... value) { ((void)!gt::decode(bytes, value), ...); }, values);
  }
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span{data, size});
  gt::AllRepresentations<Decoder>::decodeAll(bytes);
  Decoder<gt::Drawing, gt::DroppedMessages>::decodeAll(bytes);
  return 0;
}
