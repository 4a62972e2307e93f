#include "colors/ChannelHistogram.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(ChannelHistogram, TakesTheNarrowestRange) {
  ChannelHistogram line{10};
  for (const int value : {0, 4, 4, 4, 5, 6, 6, 9}) line.add(value);
  EXPECT_EQ(line.narrowest(1), (ColorRange{0, 9}));
  EXPECT_EQ(line.narrowest(0.75), (ColorRange{4, 6}));
  EXPECT_EQ(line.narrowest(0.3), (ColorRange{4, 4}));
  ChannelHistogram circle{10, true};
  for (const int value : {8, 9, 0, 0, 1, 5}) circle.add(value);
  EXPECT_EQ(circle.narrowest(0.8), (ColorRange{8, 1})) << "across zero";
  EXPECT_EQ(circle.narrowest(1), (ColorRange{5, 1}));
  EXPECT_FALSE(inRange(ChannelHistogram{10}.narrowest(1), 0)) << "nothing was seen";
}

}  // namespace
}  // namespace gt
