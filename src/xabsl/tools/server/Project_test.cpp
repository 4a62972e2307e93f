#include "xabsl/tools/server/Project.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace xabsl::server {
namespace {

TEST(Lines, CountUnitsOfUtf16) {
  const Lines lines("a\n\xC3\xBC\xF0\x9F\x98\x80x");
  EXPECT_EQ(lines.position({0, 2, 3}).character, 3);
  EXPECT_EQ(lines.location({1, 3}, 0).column, 3);
  EXPECT_EQ(lines.offset({1, 3}), 8u);
}

/// Letters of one to four bytes, in lines that are longer than what is counted at once.
TEST(Lines, CountTheSameInLongLines) {
  constexpr std::array letters{"a", "\xC3\xBC", "\xE2\x82\xAC", "\xF0\x9F\x98\x80", "b"};
  std::string text;
  std::vector<Position> positions;
  std::vector<std::size_t> offsets;
  std::vector<Location> locations;
  Position position;
  Location location{0, 1, 1};
  for (std::size_t i = 0; i < 3000; ++i) {
    positions.push_back(position);
    offsets.push_back(text.size());
    locations.push_back(location);
    const bool ends = i % 700 == 699;
    const std::string_view letter = ends ? "\n" : letters[i * i % letters.size()];
    text += letter;
    position = ends ? Position{position.line + 1, 0}
                    : Position{position.line, position.character + (letter.size() == 4 ? 2 : 1)};
    location =
        ends ? Location{0, location.line + 1, 1} : Location{0, location.line, location.column + 1};
  }
  const Lines lines{text};
  const auto at = [](Position p) { return std::pair{p.line, p.character}; };
  for (std::size_t i = 0; i < positions.size(); ++i) {
    ASSERT_EQ(at(lines.position(offsets[i])), at(positions[i])) << i;
    ASSERT_EQ(at(lines.position(locations[i])), at(positions[i])) << i;
  }
  EXPECT_EQ(at(lines.position({0, 1, 100'000})), at(positions[699])) << "the line's end";
  EXPECT_EQ(at(lines.position(text.size() + 9)), at(position));
  EXPECT_EQ(at(Lines{""}.position(std::size_t{0})), at({0, 0}));
}

}  // namespace
}  // namespace xabsl::server
