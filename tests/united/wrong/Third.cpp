#include <gtest/gtest.h>

namespace gt {

struct Words {};

TEST(Second, Name) {}

}  // namespace gt
