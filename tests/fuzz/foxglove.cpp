#include "Fuzz.h"
#include "foxglove/FoxgloveMessages.h"
#include "foxglove/FoxgloveRequest.h"
#include "streams/MessageQueue.h"

/// What viewers send, and what robots elsewhere draw for them. The first byte selects it.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  if (data[0] == '{') {
    const auto request = gt::parseFoxgloveRequest(gt::textOf(data, size));
    if (!request) return 0;
    for (const auto& parameter : request->parameters)
      if (const auto text = gt::parameterText(parameter.value))
        static_cast<void>(gt::parameterJson(parameter.name, *text));
    static_cast<void>(gt::parameterJson("x", std::string{gt::textOf(data, size)}));
    return 0;
  }
  gt::Drawing drawing;
  const gt::Message message{
      gt::messageId<gt::Drawing>(), {}, std::as_bytes(std::span{data, size}).subspan(1)};
  if (!message.read(drawing)) return 0;
  static_cast<void>(gt::foxglove::sceneEntity(drawing, {}, "field"));
  static_cast<void>(gt::foxglove::imageAnnotations(drawing, {}));
  return 0;
}
