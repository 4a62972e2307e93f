#include "views/FilmWriter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "support/FileSizeLimit.h"

namespace gt {
namespace {

/// A folder with a file that a film is to replace.
class FilmWriterTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(writeFile(file, "what was there")); }

  /// Images that no encoder makes small.
  static Result<void> addNoise(FilmWriter& film, int count) {
    RgbImage picture{64, 48, std::vector<std::uint8_t>(3 * 64 * 48)};
    unsigned noise = 1;
    for (int i = 0; i < count; ++i) {
      for (std::uint8_t& value : picture.pixels)
        value = static_cast<std::uint8_t>((noise = noise * 1664525 + 1013904223) >> 24);
      if (auto done = film.add(picture); !done) return done;
    }
    return {};
  }
  bool nothingIsLeft() const { return !std::filesystem::exists(file + ".part"); }

  TemporaryFolder folder;
  const std::string file = (folder.path() / "film.mp4").string();
};

TEST_F(FilmWriterTest, ReplacesAFileOnceTheFilmIsWhole) {
  {
    auto film = FilmWriter::open(file, 64, 48);
    ASSERT_TRUE(film) << film.error().text();
    ASSERT_TRUE(addNoise(**film, 50));
    EXPECT_EQ(*readFile(file), "what was there");
    EXPECT_FALSE(FilmWriter::open(file, 64, 48)) << "one writes at a time";
    ASSERT_TRUE((*film)->close());
  }
  EXPECT_EQ(readFile(file)->substr(4, 4), "ftyp");
  EXPECT_TRUE(nothingIsLeft());
}

TEST_F(FilmWriterTest, LeavesAFileIfTheMediumIsFull) {
  const FileSizeLimit limit{20'000};
  auto film = FilmWriter::open(file, 64, 48);
  ASSERT_TRUE(film) << film.error().text();
  const bool added = static_cast<bool>(addNoise(**film, 200));
  EXPECT_FALSE((*film)->close() && added);
  film->reset();
  EXPECT_EQ(*readFile(file), "what was there");
  EXPECT_TRUE(nothingIsLeft());
}

}  // namespace
}  // namespace gt
