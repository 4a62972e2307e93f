#include "measure/Pairs.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

using testing::ElementsAre;
constexpr auto nothing = std::nullopt;

TEST(Pairs, APerceptServesThePlaceThatItIsNearestTo) {
  EXPECT_THAT(pairNearest({{0, 0}, {100, 0}}, {{70, 0}}, 250), ElementsAre(nothing, 0u));
  EXPECT_THAT(pairNearest({{100, 0}, {0, 0}}, {{70, 0}}, 250), ElementsAre(0u, nothing));
}

TEST(Pairs, TheNearestPairComesFirst) {
  EXPECT_THAT(pairNearest({{0, 0}, {100, 0}}, {{60, 0}, {160, 0}}, 200), ElementsAre(1u, 0u));
}

TEST(Pairs, NoneIsFartherApartThanTheTolerance) {
  EXPECT_THAT(pairNearest({{0, 0}}, {{0, 251}}, 250), ElementsAre(nothing));
  EXPECT_THAT(pairNearest({{0, 0}}, {{0, 249}}, 250), ElementsAre(0u));
}

}  // namespace
}  // namespace gt
