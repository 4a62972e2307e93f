#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gt {

struct Declared;

int overloaded(const std::string& text) {
  const int local = 1;
  return static_cast<int>(text.size()) + local;
}

int commented(int number) {
  return number;
}

int quoted() {
  return 0;
}

static int numbers(int inside) {
  return inside;
}

namespace {

namespace fs = std::string_literals;
using Words = std::vector<int>;

class Bench {};

int two = 2;
const int value = 3, text = 4;
int (*table)(int) = nullptr;

}  // namespace

namespace other {
const int one = 1;
}

TEST(Second, Name) {}

}  // namespace gt
