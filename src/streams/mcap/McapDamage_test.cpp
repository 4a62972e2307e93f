// Logs that are cut off, damaged, or changed while they are written or read.
#include <gmock/gmock.h>

#include <chrono>
#include <cstring>
#include <fstream>

#include "base/File.h"
#include "streams/mcap/McapRecords.h"
#include "support/FileSizeLimit.h"
#include "support/McapVariants.h"
#include "support/TestMcap.h"

namespace gt {
namespace {

using testing::HasSubstr;

// What a crash leaves is read up to the last whole chunk.
TEST(McapDamage, ReadsLogsThatAreCutOff) {
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

TEST(McapDamage, SurvivesMutatedLogs) {
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

TEST(McapDamage, TellsWhatIsWrong) {
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

TEST(McapDamage, IsReadableUpToTheLastChunkWhenTheMediumIsFull) {
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

TEST(McapDamage, IsReadableAsFarAsItIsLeftWhenItIsTruncatedWhileItIsWritten) {
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

TEST(McapDamage, WhatIsDamagedLosesItselfOnly) {
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

TEST(McapDamage, NoticesThatItIsChangedWhileItIsRead) {
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

}  // namespace
}  // namespace gt
