#include <gtest/gtest.h>

#include "views/FilmWriter.h"

namespace gt {
namespace {

TEST(NoFilmWriter, SaysWhatIsMissing) {
  const auto film = FilmWriter::open("out/match.mp4", 64, 48);
  ASSERT_FALSE(film);
  EXPECT_NE(film.error().text().find("out/match.mp4"), std::string::npos);
  EXPECT_NE(film.error().text().find("libavcodec-dev"), std::string::npos);
}

}  // namespace
}  // namespace gt
