#pragma once
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "support/McapVariants.h"

namespace gt::variants {

/// A log as MCAP's tests of conformance have it (https://github.com/foxglove/mcap,
/// tests/conformance): its name, what is in it, and its bytes.
struct ConformanceLog {
  std::string name;
  Content content;
  std::string bytes;
};

/// What is in the logs of those tests, by the begin of their names.
inline std::vector<std::pair<std::string, Content>> conformanceContents() {
  const std::string data = "\1\2\3";
  McapChannel channel;
  channel.id = 1;
  channel.topic = "example";
  channel.messageEncoding = "a";
  channel.metadata = {{"foo", "bar"}};
  Content none, message, ten, schemaless, attachment, metadata;
  none.header = {"", "", {}};
  attachment = metadata = schemaless = none;
  attachment.attachments = {{"myFile", "application/octet-stream", 2, 1, bytesOf(data), {}}};
  metadata.metadata = {{"myMetadata", {{"foo", "bar"}}, {}}};
  schemaless.channels = {channel};
  schemaless.messages = {{1, 10, 2, 1, data}};
  message = schemaless;
  message.schemas = {{1, "Example", "c", "\4\5\6", {}}};
  message.channels.front().schema = 1;
  ten = message;
  ten.messages.clear();
  for (unsigned i = 0; i < 10; ++i) ten.messages.push_back({1, i, i, i, data});
  return {{"NoData", none},          {"OneAttachment", attachment},        {"OneMessage", message},
          {"OneMetadata", metadata}, {"OneSchemalessMessage", schemaless}, {"TenMessages", ten}};
}

/// All 416 of them: each content in each set of features that makes a difference.
inline std::vector<ConformanceLog> conformanceLogs() {
  constexpr std::pair<Feature, const char*> names[] = {
      {attachmentIndex, "-ax"}, {chunks, "-ch"},  {chunkIndex, "-chx"},     {metadataIndex, "-mdx"},
      {messageIndex, "-mx"},    {pads, "-pad"},   {repeatChannels, "-rch"}, {repeatSchemas, "-rsh"},
      {statistics, "-st"},      {offsets, "-sum"}};
  constexpr unsigned inIndex =
      attachmentIndex | chunkIndex | metadataIndex | repeatChannels | repeatSchemas | statistics;
  std::vector<ConformanceLog> all;
  for (const auto& [begin, content] : conformanceContents()) {
    const auto makesADifference = [&content = content](unsigned features) {
      const auto has = [&](unsigned feature) { return (features & feature) != 0; };
      return !(has(chunks | repeatChannels) && content.channels.empty()) &&
             !(has(chunkIndex | messageIndex) && !has(chunks)) &&
             !(has(repeatSchemas) && content.schemas.empty()) &&
             !(has(attachmentIndex) && content.attachments.empty()) &&
             !(has(metadataIndex) && content.metadata.empty()) && !(has(offsets) && !has(inIndex));
    };
    for (unsigned set = 0; set < 1u << std::size(names); ++set) {
      ConformanceLog log{begin, content, {}};
      unsigned features = endMagic | checksums;
      for (std::size_t i = 0; i < std::size(names); ++i) {
        if ((set >> i & 1u) == 0) continue;
        features |= names[i].first;
        log.name += names[i].second;
      }
      if (!makesADifference(features)) continue;
      if ((features & pads) != 0) addRests(log.content);
      log.bytes = VariantWriter{features, log.content, 10}.write();
      all.push_back(std::move(log));
    }
  }
  return all;
}

}  // namespace gt::variants
