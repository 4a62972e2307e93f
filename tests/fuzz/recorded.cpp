#include <algorithm>
#include <nlohmann/json.hpp>

#include "Fuzz.h"
#include "streams/RecordedMessage.h"
#include "streams/RecordedTable.h"
#include "streams/Schema.h"

// A schema up to the first zero, then a message of it.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* end = std::find(data, data + size, 0);
  const std::string_view text = gt::textOf(data, static_cast<std::size_t>(end - data));
  const auto definition = gt::MessageDefinition::parse("fuzz_msgs/msg/Fuzz", text);
  if (!definition) return 0;
  const std::span message{data + text.size(), size - text.size()};
  static_cast<void>(gt::recordedJson(*definition, std::as_bytes(message)));
  gt::CompressedImage image;
  static_cast<void>(gt::readRecorded(*definition, std::as_bytes(message), image));
  if (auto table = gt::RecordedTable::make(*definition))
    for (int i = 0; i < 2; ++i) static_cast<void>(table->add(std::as_bytes(message)));
  return 0;
}
