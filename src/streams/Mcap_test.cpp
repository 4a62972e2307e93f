#include "streams/Mcap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "streams/File.h"
#include "streams/Jpeg.h"
#include "streams/McapRecords.h"
#include "support/FileSizeLimit.h"
#include "support/McapVariants.h"
#include "support/Samples.h"

namespace gt {
namespace {

using samples::Everything;
using samples::Inner;
using testing::HasSubstr;

constexpr int messageCount = 600;

/// A file that is removed at the end.
struct TemporaryFile {
  std::string path;
  explicit TemporaryFile(const std::string& name) : path{testing::TempDir() + name} {}
  ~TemporaryFile() { std::filesystem::remove(path); }
};

/// The content of the message of this number.
Inner inner(int i) {
  return {i % 2 == 0, "message " + std::to_string(i), i * 0.1};
}

CompressedImage picture() {
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
void writeLog(const std::string& path, const McapOptions& options = {true, 1, 5000}) {
  auto writer = McapWriter::open(path, options);
  ASSERT_TRUE(writer);
  writer->metadata("run", {{"seed", "7"}, {"scene", "match"}});
  const auto channel = writer->addChannel<Inner>("/inner");
  Random random{8};
  for (int i = 0; i < messageCount; ++i) {
    writer->write(channel, Time{i * 8}, inner(i));
    if (i % 50 != 0) continue;
    Everything everything;
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
int readAll(McapReader& reader) {
  int count = 0;
  while (const auto message = reader.next()) {
    Inner read;
    if (reader.channel(message->channel)->topic == "/inner" && decode(message->data, read)) ++count;
  }
  return count;
}

/// The damage of a log, a line each.
std::string damageOf(const McapReader& reader) {
  std::string text;
  for (const Error& error : reader.damage()) text += error.text() + "\n";
  return text;
}

TEST(Mcap, ReadsWhatItWrote) {
  for (const bool compress : {true, false}) {
    const TemporaryFile file{"Mcap_test_read.mcap"};
    writeLog(file.path, {compress, 1, 5000});
    auto reader = McapReader::open(file.path);
    ASSERT_TRUE(reader) << reader.error().text();
    EXPECT_TRUE(reader->complete());
    EXPECT_EQ(damageOf(*reader), "");
    ASSERT_EQ(reader->channels().size(), 3u);
    const McapChannel& c = reader->channels()[0];
    EXPECT_EQ(c.topic, "/inner");
    EXPECT_EQ(c.messageEncoding, "cdr");
    EXPECT_EQ(c.schemaEncoding, "ros2msg");
    EXPECT_EQ(c.schemaName, "gt2003_msgs/msg/Inner");
    EXPECT_EQ(c.schemaText, schemaOf<Inner>().text);
    EXPECT_EQ(c.messageCount, static_cast<std::uint64_t>(messageCount));
    ASSERT_EQ(reader->metadata().size(), 1u);
    EXPECT_EQ(reader->metadata()[0].entries.at("seed"), "7");
    ASSERT_EQ(reader->attachments().size(), 1u);
    EXPECT_EQ(reader->attachments()[0].data.size(), 6u);
    int i = 0;
    while (const auto m = reader->next()) {
      if (m->channel != c.id) continue;
      Inner read;
      ASSERT_TRUE(decode(m->data, read));
      ASSERT_EQ(m->time, nanoseconds(Time{i * 8}));
      ASSERT_EQ(m->publishTime, m->time);
      ASSERT_EQ(m->sequence, static_cast<std::uint32_t>(i));
      ASSERT_EQ(read.text, inner(i).text);
      ASSERT_EQ(read.value, inner(i).value);
      ++i;
    }
    EXPECT_EQ(i, messageCount);
  }
}

// tests/mcap/check.mjs reads this log with readers that know nothing of this project.
TEST(Mcap, LeavesALogForOtherReaders) {
  std::filesystem::create_directories("out/tests");
  writeLog("out/tests/streams.mcap");
  const auto reader = McapReader::open("out/tests/streams.mcap");
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->complete());
}

TEST(Mcap, WritesTheSameBytesAgain) {
  const TemporaryFile a{"Mcap_test_a.mcap"}, b{"Mcap_test_b.mcap"};
  writeLog(a.path);
  writeLog(b.path);
  EXPECT_EQ(*readFile(a.path), *readFile(b.path));
}

TEST(Mcap, SeeksATime) {
  const TemporaryFile file{"Mcap_test_seek.mcap"};
  writeLog(file.path);
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader);
  reader->seek(2'000'000'000);
  const auto first = reader->next();
  ASSERT_TRUE(first);
  EXPECT_GT(first->time, 1'000'000'000u);
  EXPECT_LE(first->time, 2'000'000'000u);
  reader->seek(0);
  const auto again = reader->next();
  ASSERT_TRUE(again);
  EXPECT_EQ(again->time, 0u);
}

// What a crash leaves is read up to the last whole chunk.
TEST(Mcap, ReadsLogsThatAreCutOff) {
  const TemporaryFile file{"Mcap_test_cut.mcap"};
  writeLog(file.path);
  const std::string whole = *readFile(file.path);
  int before = 0;
  for (std::size_t n = 0; n < whole.size(); n += 100) {
    ASSERT_TRUE(writeFile(file.path, std::string_view{whole}.substr(0, n)));
    auto reader = McapReader::open(file.path);
    if (n < 200 && !reader) continue;
    ASSERT_TRUE(reader) << n << reader.error().text();
    EXPECT_FALSE(reader->complete());
    const int count = readAll(*reader);
    EXPECT_GE(count, before) << n;
    EXPECT_EQ(reader->damage().size(), 1u) << damageOf(*reader);
    before = count;
  }
  EXPECT_EQ(before, messageCount);
}

TEST(Mcap, SurvivesMutatedLogs) {
  const TemporaryFile file{"Mcap_test_mutated.mcap"};
  writeLog(file.path, {true, 1, 20000});
  const std::string whole = *readFile(file.path);
  Random random{9};
  int damaged = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string bad = whole;
    const std::size_t size = bad.size();
    // Half of the changes hit the begin or the end, where the structure is densest.
    for (int k = 0; k < 3; ++k) {
      const auto at = random.index(1000);
      bad[random.chance(0.5)   ? random.index(size)
          : random.chance(0.5) ? at
                               : size - 1 - at] = static_cast<char>(random());
    }
    ASSERT_TRUE(writeFile(file.path, bad));
    auto reader = McapReader::open(file.path);
    if (reader) readAll(*reader);
    if (!reader || !reader->damage().empty()) ++damaged;
  }
  EXPECT_GT(damaged, 500);
}

TEST(Mcap, TellsWhatIsWrong) {
  const TemporaryFile file{"Mcap_test_wrong.mcap"};
  const auto missing = McapReader::open(file.path);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().text(), file.path + ": there is no such file");
  ASSERT_TRUE(writeFile(file.path, "garbage garbage garbage"));
  const auto garbage = McapReader::open(file.path);
  ASSERT_FALSE(garbage);
  EXPECT_EQ(garbage.error().text(), file.path + ": is not an MCAP file");
  EXPECT_FALSE(McapWriter::open("/nowhere/a.mcap"));

  writeLog(file.path);
  std::string bytes = *readFile(file.path);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] + 1);
  ASSERT_TRUE(writeFile(file.path, bytes));
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader);
  const int count = readAll(*reader);
  EXPECT_LT(count, messageCount);
  EXPECT_GT(count, messageCount / 2);
  ASSERT_EQ(reader->damage().size(), 1u);
  EXPECT_THAT(damageOf(*reader),
              testing::MatchesRegex(".*Mcap_test_wrong.mcap: [0-9.]+ s to [0-9.]+ s: the "
                                    "chunk.*; its messages are lost\n"));
  reader->seek(0);
  EXPECT_EQ(readAll(*reader), count);
  EXPECT_EQ(reader->damage().size(), 1u) << "each once";
}

TEST(Mcap, TellsOfAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  auto writer = McapWriter::open("/dev/full", {false, 1, 100});
  ASSERT_TRUE(writer);
  EXPECT_FALSE(writer->takeError());
  for (int i = 0; i < 1000; ++i) writer->write("/inner", Time{i}, inner(i));
  const auto taken = writer->takeError();
  ASSERT_TRUE(taken) << "is known before the log is closed";
  EXPECT_FALSE(writer->takeError());
  const auto result = writer->close();
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().text(), taken->text());
  EXPECT_THAT(result.error().text(), HasSubstr("/dev/full: cannot be written: No space"));
}

TEST(Mcap, IsWrittenByOneAtATime) {
  const TemporaryFile file{"Mcap_test_locked.mcap"};
  auto writer = McapWriter::open(file.path);
  ASSERT_TRUE(writer);
  writer->write("/inner", Time{1}, inner(1));
  const auto second = McapWriter::open(file.path);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().text(), file.path + ": is being written by another program or match");
  ASSERT_TRUE(writer->close());
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_TRUE(reader->complete());
  EXPECT_TRUE(McapWriter::open(file.path)) << "a log that is closed may be written anew";
}

TEST(Mcap, TellsThatItWasRemovedWhileItWasWritten) {
  const TemporaryFile file{"Mcap_test_removed.mcap"};
  auto writer = McapWriter::open(file.path, {false, 1, 1000});
  ASSERT_TRUE(writer);
  std::filesystem::remove(file.path);
  for (int i = 0; i < 1000; ++i) writer->write("/inner", Time{i}, inner(i));
  const auto taken = writer->takeError();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->text(), file.path + ": was removed while it was written");
  EXPECT_FALSE(writer->close());
}

TEST(Mcap, IsReadableUpToTheLastChunkWhenTheMediumIsFull) {
  const TemporaryFile file{"Mcap_test_full.mcap"};
  {
    const FileSizeLimit limit{40'000};
    auto writer = McapWriter::open(file.path, {false, 1, 1000});
    ASSERT_TRUE(writer);
    for (int i = 0; i < 5000; ++i) writer->write("/inner", Time{i}, inner(i));
    const auto result = writer->close();
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().text(), HasSubstr("cannot be written: File too large"));
  }
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_FALSE(reader->complete());
  const int count = readAll(*reader);
  EXPECT_GT(count, 200);
  EXPECT_LT(count, 5000);
  EXPECT_EQ(reader->damage().size(), 1u) << damageOf(*reader);
}

TEST(Mcap, IsReadableAsFarAsItIsLeftWhenItIsTruncatedWhileItIsWritten) {
  const TemporaryFile file{"Mcap_test_truncated.mcap"};
  auto writer = McapWriter::open(file.path, {false, 1, 1000});
  ASSERT_TRUE(writer);
  for (int i = 0; i < 2000; ++i) writer->write("/inner", Time{i}, inner(i));
  ASSERT_TRUE(writer->flush());
  writer->write("/late", Time{2000}, picture());  // a channel that waits to be written
  const auto left = std::filesystem::file_size(file.path) / 2;
  std::filesystem::resize_file(file.path, left);
  for (int i = 2000; i < 4000; ++i) writer->write("/inner", Time{i}, inner(i));
  const auto flushed = writer->flush(), closed = writer->close();
  ASSERT_FALSE(flushed);
  ASSERT_FALSE(closed);
  EXPECT_EQ(flushed.error().text(), file.path + ": was truncated while it was written");
  EXPECT_EQ(closed.error().text(), flushed.error().text());
  EXPECT_EQ(std::filesystem::file_size(file.path), left);
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_FALSE(reader->complete());
  const int count = readAll(*reader);
  EXPECT_GT(count, 800);
  EXPECT_LT(count, 1200);
  EXPECT_EQ(reader->damage().size(), 1u) << damageOf(*reader);
}

/// A log of one chunk in lz4, as other programs write them.
std::string lz4Log(const Schema& schema, std::span<const std::byte> message) {
  using namespace mcap;
  Bytes out, chunk;
  append(out, std::as_bytes(std::span{magic, magicSize}));
  const auto record = [](Bytes& to, Opcode opcode, const auto& fill) {
    const std::size_t at = beginRecord(to, opcode);
    fill(to);
    endRecord(to, at);
  };
  record(out, Opcode::header, [](Bytes& to) {
    append(to, std::string_view{"ros2"});
    append(to, std::string_view{"test"});
  });
  record(chunk, Opcode::schema, [&](Bytes& to) {
    append(to, std::uint16_t{1});
    append(to, std::string_view{schema.name});
    append(to, std::string_view{"ros2msg"});
    append(to, std::string_view{schema.text});
  });
  record(chunk, Opcode::channel, [](Bytes& to) {
    append(to, std::uint16_t{7});
    append(to, std::uint16_t{1});
    append(to, std::string_view{"/inner"});
    append(to, std::string_view{"cdr"});
    append(to, TextMap{});
  });
  for (int i = 0; i < 100; ++i)
    record(chunk, Opcode::message, [&](Bytes& to) {
      append(to, std::uint16_t{7});
      append(to, std::uint32_t{0});
      append(to, std::uint64_t{5});
      append(to, std::uint64_t{5});
      append(to, message);
    });
  Bytes packed(LZ4F_compressFrameBound(chunk.size(), nullptr));
  packed.resize(
      LZ4F_compressFrame(packed.data(), packed.size(), chunk.data(), chunk.size(), nullptr));
  record(out, Opcode::chunk, [&](Bytes& to) {
    append(to, std::uint64_t{5});
    append(to, std::uint64_t{5});
    append(to, std::uint64_t{chunk.size()});
    append(to, std::uint32_t{0});
    append(to, std::string_view{"lz4"});
    append(to, std::uint64_t{packed.size()});
    append(to, packed);
  });
  record(out, Opcode::dataEnd, [](Bytes& to) { append(to, std::uint32_t{0}); });
  return {reinterpret_cast<const char*>(out.data()), out.size()};
}

TEST(Mcap, ReadsChunksInLz4) {
  const TemporaryFile file{"Mcap_test_lz4.mcap"};
  std::vector<std::byte> message;
  encode(inner(3), message);
  const std::string log = lz4Log(schemaOf<Inner>(), message);
  ASSERT_TRUE(writeFile(file.path, log));
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_EQ(readAll(*reader), 100);
  for (std::size_t i = 200; i < log.size(); i += 7) {
    std::string bad = log;
    bad[i] = static_cast<char>(bad[i] ^ 0x55);
    ASSERT_TRUE(writeFile(file.path, bad));
    if (auto damaged = McapReader::open(file.path)) readAll(*damaged);
  }
}

TEST(Mcap, TellsChannelsOfOneTopicApartByTheirSchemas) {
  const TemporaryFile file{"Mcap_test_topics.mcap"};
  auto writer = McapWriter::open(file.path);
  ASSERT_TRUE(writer);
  const auto first = writer->addChannel<Inner>("/a");
  EXPECT_EQ(writer->addChannel<Inner>("/a"), first);
  EXPECT_NE(writer->addChannel("/a", CompressedImage::schema()), first);
  McapChannel other;
  other.id = 9;
  other.topic = "/a";
  other.messageEncoding = "json";
  other.schema = writer->addSchema({4, "x", "jsonschema", "{}"});
  EXPECT_EQ(other.schema, 4);
  EXPECT_EQ(writer->addChannel(other), 9);
  EXPECT_NE(writer->addChannel(other), 9) << "each as it stands in the other log";
  ASSERT_TRUE(writer->close());
  const auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader);
  ASSERT_EQ(reader->channels().size(), 4u);
  EXPECT_EQ(reader->channels()[2].messageEncoding, "json");
  EXPECT_EQ(reader->channels()[2].schemaEncoding, "jsonschema");
}

TEST(McapVariants, HoldTheSame) {
  const TemporaryFile file{"Mcap_test_variant.mcap"};
  for (const unsigned features : variants::allVariants()) {
    std::filesystem::remove(file.path);  // to replace a file may take its time
    ASSERT_TRUE(writeFile(file.path, variants::logWith(features)));
    auto reader = McapReader::open(file.path);
    ASSERT_TRUE(reader) << features << ": " << reader.error().text();
    ASSERT_EQ(variants::textOf(variants::readContent(*reader)),
              variants::textOf(variants::contentOf(features)))
        << features;
    const bool ends = (features & variants::endMagic) != 0;
    ASSERT_EQ(reader->complete(), ends) << features;
    ASSERT_TRUE(reader->hasDataChecksum()) << features;
    ASSERT_EQ(damageOf(*reader), ends ? ""
                                      : file.path +
                                            ": the last bytes of the log are missing; its "
                                            "messages are whole\n")
        << features;
    reader->seek(3'000'000'000);
    const auto later = reader->next();
    ASSERT_TRUE(later) << features;
    reader->seek(~std::uint64_t{0} - 1);
    ASSERT_TRUE(reader->next()) << features << ": times of all 64 bits";
  }
}

TEST(McapVariants, OfTheConformanceTestsHoldWhatTheirNamesSay) {
  const TemporaryFile file{"Mcap_test_conformance.mcap"};
  const auto logs = variants::conformanceLogs();
  EXPECT_EQ(logs.size(), 416u);
  for (const variants::ConformanceLog& log : logs) {
    std::filesystem::remove(file.path);
    ASSERT_TRUE(writeFile(file.path, log.bytes));
    auto reader = McapReader::open(file.path);
    ASSERT_TRUE(reader) << log.name << ": " << reader.error().text();
    ASSERT_EQ(variants::textOf(variants::readContent(*reader)), variants::textOf(log.content))
        << log.name;
    ASSERT_EQ(damageOf(*reader), "") << log.name;
    ASSERT_TRUE(reader->complete() && reader->hasDataChecksum()) << log.name;
  }
}

/// Where an opcode begins a record of a log, from the given one on.
std::size_t recordAt(const std::string& log, mcap::Opcode opcode, int number) {
  std::size_t at = mcap::magicSize;
  for (int found = -1; at + mcap::recordHeaderSize <= log.size();) {
    if (log[at] == static_cast<char>(opcode) && ++found == number) return at;
    std::uint64_t length = 0;
    std::memcpy(&length, log.data() + at + 1, sizeof length);
    at += mcap::recordHeaderSize + length;
  }
  ADD_FAILURE() << "there is no such record";
  return 0;
}

/// The numbers of the messages that are left of a log of which a byte is changed.
std::string leftOf(const std::string& log, std::size_t at, std::string* damage) {
  const TemporaryFile file{"Mcap_test_left.mcap"};
  std::string bad = log;
  bad[at] = static_cast<char>(bad[at] ^ 0x40);
  EXPECT_TRUE(writeFile(file.path, bad));
  auto reader = McapReader::open(file.path);
  EXPECT_TRUE(reader);
  std::string left;
  while (const auto m = reader->next())
    if (m->channel == 2) left += std::to_string(m->sequence) + " ";
  *damage = damageOf(*reader).substr(file.path.size() + 2);
  return left;
}

TEST(Mcap, WhatIsDamagedLosesItselfOnly) {
  using enum mcap::Opcode;
  for (const unsigned index : {0u, unsigned{variants::chunkIndex | variants::statistics |
                                            variants::repeatSchemas | variants::repeatChannels}}) {
    const std::string log =
        variants::logWith(variants::chunks | variants::checksums | variants::endMagic | index);
    std::string damage;
    const std::size_t second = recordAt(log, chunk, 1);
    EXPECT_EQ(leftOf(log, second + 100, &damage), "70 72 73 ");
    EXPECT_EQ(damage, "2.000 s: the chunk's checksum is wrong; its messages are lost\n");
    EXPECT_EQ(leftOf(log, recordAt(log, attachment, 0) + 60, &damage), "70 71 72 73 ");
    EXPECT_EQ(damage, "attachment note.txt: its checksum is wrong; it is lost\n");
    // Where the chunk ends, only the index states.
    const std::string left = leftOf(log, second + 8, &damage);
    EXPECT_EQ(left, index != 0 ? "70 72 73 " : "70 ");
    EXPECT_THAT(damage, testing::StartsWith(index != 0 ? "2.000 s: " : "after 1.000 s: "));
  }
  // Outside of chunks only the checksum of all data shows a wrong byte.
  const TemporaryFile file{"Mcap_test_sum.mcap"};
  std::string plain = variants::logWith(variants::checksums | variants::endMagic);
  plain[recordAt(plain, message, 0) + 20] ^= 1;
  ASSERT_TRUE(writeFile(file.path, plain));
  EXPECT_FALSE(McapReader::open(file.path)->hasDataChecksum());
  // An index that is wrong costs nothing.
  const unsigned chunked = variants::chunks | variants::chunkIndex | variants::endMagic;
  const std::string log = variants::logWith(chunked);
  std::string damage;
  const std::size_t index = recordAt(log, chunkIndex, 1);
  EXPECT_EQ(leftOf(log, index + mcap::recordHeaderSize + 16, &damage), "70 71 72 73 ");
  EXPECT_EQ(damage, "the index is wrong; the log was read without it\n");
  EXPECT_EQ(leftOf(variants::logWith(chunked | variants::checksums), index + 10, &damage),
            "70 71 72 73 ");
  EXPECT_EQ(damage, "the index is damaged; the log was read without it\n");
}

TEST(Mcap, NoticesThatItIsChangedWhileItIsRead) {
  const TemporaryFile file{"Mcap_test_changed.mcap"};
  const std::string log = variants::logWith(variants::allFeatures);
  const auto open = [&] {
    EXPECT_TRUE(writeFile(file.path, log));
    auto reader = McapReader::open(file.path);
    EXPECT_TRUE(reader->next());
    return std::move(*reader);
  };
  const auto expectEnd = [&](McapReader& reader) {
    while (reader.next()) {
    }
    EXPECT_EQ(damageOf(reader),
              file.path +
                  ": after 1.000 s: the log was changed by another program; what followed is left "
                  "out\n");
  };
  auto truncated = open();
  std::filesystem::resize_file(file.path, log.size() / 2);
  expectEnd(truncated);
  auto emptied = open();
  std::filesystem::resize_file(file.path, 0);
  expectEnd(emptied);
  auto overwritten = open();
  std::fstream{file.path, std::ios::in | std::ios::out | std::ios::binary}.write(log.data(), 9);
  std::filesystem::last_write_time(
      file.path, std::filesystem::file_time_type::clock::now() + std::chrono::seconds{1});
  expectEnd(overwritten);
  auto removed = open();
  std::filesystem::remove(file.path);
  while (removed.next()) {
  }
  EXPECT_EQ(damageOf(removed), "") << "it is still there for who has opened it";

  // A log that is being written is longer each time.
  auto writer = McapWriter::open(file.path, {false, 1, 100});
  writer->write("/inner", Time{1}, inner(1));
  ASSERT_TRUE(writer->flush());
  auto growing = McapReader::open(file.path);
  writer->write("/inner", Time{2}, inner(2));
  ASSERT_TRUE(writer->flush());
  EXPECT_EQ(readAll(*growing), 1);
  EXPECT_THAT(damageOf(*growing), HasSubstr("after 0.001 s: the log is cut off"));
}

TEST(Mcap, IsWrittenAtOnceOrNotAtAll) {
  const TemporaryFile file{"Mcap_test_once.mcap"};
  McapOptions options{false, 1, 1000};
  options.atOnce = true;
  const auto write = [&](McapWriter& writer) {
    for (int i = 0; i < 2000; ++i) writer.write("/inner", Time{i}, inner(i));
  };
  ASSERT_TRUE(writeFile(file.path, "what was there"));
  {
    auto left = McapWriter::open(file.path, options);
    ASSERT_TRUE(left);
    write(*left);
    EXPECT_FALSE(McapWriter::open(file.path, options)) << "one writes at a time";
  }
  EXPECT_EQ(*readFile(file.path), "what was there");
  {
    const FileSizeLimit limit{40'000};
    auto full = McapWriter::open(file.path, options);
    ASSERT_TRUE(full);
    write(*full);
    EXPECT_FALSE(full->close());
  }
  EXPECT_EQ(*readFile(file.path), "what was there");
  EXPECT_FALSE(std::filesystem::exists(file.path + ".part"));
  auto whole = McapWriter::open(file.path, options);
  write(*whole);
  ASSERT_TRUE(whole->close());
  auto reader = McapReader::open(file.path);
  ASSERT_TRUE(reader) << reader.error().text();
  EXPECT_EQ(readAll(*reader), 2000);
  EXPECT_EQ(damageOf(*reader), "");
  EXPECT_FALSE(std::filesystem::exists(file.path + ".part"));
}

}  // namespace
}  // namespace gt
