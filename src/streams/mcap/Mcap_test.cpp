#include "streams/mcap/Mcap.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lz4frame.h>

#include <filesystem>

#include "base/File.h"
#include "streams/mcap/McapRecords.h"
#include "support/FileSizeLimit.h"
#include "support/McapConformance.h"
#include "support/McapVariants.h"
#include "support/TestMcap.h"

namespace gt {
namespace {

using samples::Inner;
using testing::HasSubstr;

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
