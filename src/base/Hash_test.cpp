#include "base/Hash.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

// The values that the authors of FNV publish.
TEST(Hash, IsFnv1a) {
  static_assert(hashOf("") == 0x811c9dc5);
  static_assert(hashOf("foobar") == 0xbf9cf968);
  Fingerprint empty, text;
  EXPECT_EQ(empty.value(), 0xcbf29ce484222325);
  text.add("foobar");
  EXPECT_EQ(text.value(), 0x85944171f73967e8);
}

TEST(Hash, TakesNumbersByTheirBytes) {
  const double numbers[] = {1, -2.5};
  Fingerprint one, all, bytes;
  for (const double number : numbers) one.add(number);
  all.add(numbers, 2);
  bytes.addBytes(numbers, sizeof numbers);
  EXPECT_EQ(one.value(), all.value());
  EXPECT_EQ(one.value(), bytes.value());
}

}  // namespace
}  // namespace gt
