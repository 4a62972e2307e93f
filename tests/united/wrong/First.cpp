#include <functional>
#include <string>
#include <vector>

// int commented(int);
namespace gt {

struct Declared;

int overloaded(int number) {
  return number;
}

namespace {

namespace fs = std::string_literals;
using Words = std::vector<std::string>;
const std::string text = R"(int quoted() { return 0; })";
constexpr int one = 1 << 2, two = 3;
const std::function<int(int)> table[]{[](int i) { return i; }};
enum Column { name, value };

template <typename T>
struct Bench {
  int inside = 0;
};

std::vector<int> numbers() {
  const int local = 1'000;
  return {local};
}

}  // namespace
}  // namespace gt
