#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "images/Jpeg.h"
#include "streams/mcap/Mcap.h"
#include "support/Samples.h"

namespace gt {

constexpr int messageCount = 600;

/// A file that is removed at the end.
struct TemporaryFile {
  std::string path;
  explicit TemporaryFile(const std::string& name) : path{testing::TempDir() + name} {}
  ~TemporaryFile() { std::filesystem::remove(path); }
};

/// The content of the message of this number.
inline samples::Inner inner(int i) {
  return {i % 2 == 0, "message " + std::to_string(i), i * 0.1};
}

inline CompressedImage picture() {
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int c : {x * 4, y * 5, 128, 0}) pixels.push_back(static_cast<std::uint8_t>(c));
  CompressedImage image;
  image.header = {RosTime::of(Time{40}), "camera"};
  image.data = encodeJpeg(pixels.data(), 64, 48);
  return image;
}

/// A log with three channels, small chunks, metadata and an attachment.
inline void writeLog(const std::string& path, const McapOptions& options = {true, 1, 5000}) {
  auto writer = McapWriter::open(path, options);
  ASSERT_TRUE(writer);
  writer->metadata("run", {{"seed", "7"}, {"scene", "match"}});
  const auto channel = writer->addChannel<samples::Inner>("/inner");
  Random random{8};
  for (int i = 0; i < messageCount; ++i) {
    writer->write(channel, Time{i * 8}, inner(i));
    if (i % 50 != 0) continue;
    samples::Everything everything;
    samples::randomize(valueOf(everything), random);
    everything.text = "t";
    everything.texts = {"a", "b"};
    for (auto& in : everything.inners) in.text = "x";
    for (auto& in : everything.list) in.text = "y";
    everything.inner.text = "z";
    writer->write("/everything", Time{i * 8}, everything);
    writer->write("/camera", Time{i * 8}, picture());
  }
  const std::string note = "a note";
  writer->attachment("note.txt", "text/plain", Time{9}, std::as_bytes(std::span{note}));
  const auto closed = writer->close();
  ASSERT_TRUE(closed) << closed.error().text();
}

/// Reads all messages. Returns how many of /inner can be decoded.
inline int readAll(McapReader& reader) {
  int count = 0;
  while (const auto message = reader.next()) {
    samples::Inner read;
    if (reader.channel(message->channel)->topic == "/inner" && decode(message->data, read)) ++count;
  }
  return count;
}

/// The damage of a log, a line each.
inline std::string damageOf(const McapReader& reader) {
  std::string text;
  for (const Error& error : reader.damage()) text += error.text() + "\n";
  return text;
}

}  // namespace gt
