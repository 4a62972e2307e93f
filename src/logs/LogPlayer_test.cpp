#include "logs/LogPlayer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/TemporaryFolder.h"
#include "debug/Drawing.h"

namespace gt {
namespace {

using ::testing::ElementsAre;

/// A log of texts 0, 1, 2, ...: three every 10 ms, the last of which came late, in small chunks.
class LogPlayerTest : public ::testing::Test {
 protected:
  LogPlayerTest() {
    auto writer = McapWriter::open(path, {true, 1, 200});
    for (int i = 0; i < 60; ++i)
      writer->write("/Text", Time{1000 + i / 3 * 10 - (i % 3 == 2 ? 4 : 0)},
                    Text{std::to_string(i)});
    EXPECT_TRUE(writer->close());
    auto opened = LogPlayer::open(path);
    EXPECT_TRUE(opened) << opened.error().text();
    player.emplace(std::move(*opened));
  }
  /// Plays a moment; returns its texts.
  std::vector<std::string> next() {
    std::vector<std::string> texts;
    const auto more = player->next([&](const McapChannel&, const McapMessage& message) {
      Text text;
      EXPECT_TRUE(decode(message.data, text));
      texts.push_back(text.text);
      return Result<void>{};
    });
    EXPECT_TRUE(more);
    return texts;
  }

  TemporaryFolder folder;
  std::string path = (folder.path() / "log.mcap").string();
  std::optional<LogPlayer> player;
};

TEST_F(LogPlayerTest, PlaysMomentByMoment) {
  EXPECT_EQ(player->messages(), 60u);
  ASSERT_EQ(player->moments().size(), 20u);
  EXPECT_EQ(player->begin(), Time{1000});
  EXPECT_EQ(player->end(), Time{1190});
  EXPECT_THAT(next(), ElementsAre("0", "1", "2"));
  EXPECT_THAT(next(), ElementsAre("3", "4", "5"));
  EXPECT_EQ(player->now(), Time{1010});
  for (int i = 2; i < 20; ++i) EXPECT_EQ(next().size(), 3u);
  EXPECT_TRUE(player->atEnd());
  EXPECT_THAT(next(), ElementsAre());
}

TEST_F(LogPlayerTest, GoesToMomentsTimesAndMessages) {
  for (const std::size_t moment : {17u, 3u, 0u, 19u, 4u, 5u}) {
    player->seek(moment);
    EXPECT_EQ(next().front(), std::to_string(3 * moment));
  }
  player->seekTime(Time{1051});
  EXPECT_EQ(next().front(), "18");
  player->seekTime(Time{0});
  EXPECT_EQ(next().front(), "0");
  player->seekMessage(35);
  EXPECT_THAT(next(), ElementsAre("33", "34", "35"));
  player->seekMessage(1'000'000);
  EXPECT_EQ(next().front(), "57");
}

TEST_F(LogPlayerTest, LetsTimePassAtItsSpeed) {
  const auto due = [&] {
    int count = 0;
    for (; player->due(); ++count) next();
    return count;
  };
  EXPECT_EQ(due(), 1) << "the first moment is due at once";
  player->pass(25);
  EXPECT_EQ(due(), 2);
  player->setSpeed(4);
  player->pass(10);
  EXPECT_EQ(due(), 4);
  player->pause();
  player->pass(1000);
  EXPECT_EQ(due(), 0);
  player->play();
  player->setSpeed(1);
  player->pass(1000);
  EXPECT_EQ(due(), 13);
  EXPECT_FALSE(player->due());
  player->setLoop(true);
  EXPECT_TRUE(player->due());
  EXPECT_EQ(next().front(), "0");
  EXPECT_FALSE(player->due());
}

TEST_F(LogPlayerTest, WaitsForItsBegin) {
  player->waitFrom(Time{990});
  EXPECT_EQ(player->time(), Time{990});
  player->pass(9);
  EXPECT_FALSE(player->due());
  player->pass(1);
  EXPECT_TRUE(player->due());
  EXPECT_EQ(player->time(), Time{1000});
}

TEST_F(LogPlayerTest, EndsWhereAnotherProgramHasChangedTheLog) {
  EXPECT_THAT(next(), ElementsAre("0", "1", "2"));
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const auto ignore = [](const McapChannel&, const McapMessage&) { return Result<void>{}; };
  std::vector<std::string> errors;
  for (int i = 0; i < 30; ++i)
    if (const auto more = player->next(ignore); !more) errors.push_back(more.error().text());
  EXPECT_TRUE(player->atEnd());
  EXPECT_THAT(errors,
              ElementsAre(testing::HasSubstr(
                  " s: the log was changed by another program; what followed is left out")));
}

TEST_F(LogPlayerTest, NeedsAWholeLog) {
  EXPECT_FALSE(LogPlayer::open((folder.path() / "none.mcap").string()));
  const std::string empty = (folder.path() / "empty.mcap").string();
  ASSERT_TRUE(McapWriter::open(empty)->close());
  EXPECT_EQ(LogPlayer::open(empty).error().what, "the log holds no messages");
}

}  // namespace
}  // namespace gt
