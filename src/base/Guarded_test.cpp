#include "base/Guarded.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>

namespace gt {
namespace {

template <typename E>
std::string textOfThrown(const E& exception) {
  const auto done = guarded([&]() -> Result<int> { throw exception; });
  return done ? "" : done.error().text();
}

TEST(Guarded, AnExceptionIsAnErrorOfOneLine) {
  using std::filesystem::filesystem_error;
  const auto missing = std::make_error_code(std::errc::no_such_file_or_directory);
  EXPECT_EQ(textOfThrown(std::bad_alloc{}), "not enough memory");
  EXPECT_EQ(textOfThrown(filesystem_error{"copy", "/nowhere", missing}),
            "/nowhere: No such file or directory");
  EXPECT_EQ(textOfThrown(filesystem_error{"temp_directory_path", missing}),
            "exception: filesystem error: temp_directory_path: No such file or directory");
  EXPECT_EQ(textOfThrown(std::runtime_error{"three"}), "exception: three");
}

TEST(Guarded, ReturnsWhatTheWorkReturns) {
  EXPECT_EQ(*guarded([] { return Result<int>{7}; }), 7);
  EXPECT_EQ(guarded([]() -> Result<int> { return Error{.what = "wrong"}; }).error().text(),
            "wrong");
}

}  // namespace
}  // namespace gt
