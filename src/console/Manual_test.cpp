#include "console/Manual.h"

#include <gtest/gtest.h>

#include "base/File.h"

namespace gt {
namespace {

TEST(Manual, IsInTheDocumentation) {
  EXPECT_EQ(*readFile("docs/console.md"), consoleManual())
      << "simgt commands > docs/console.md brings it up to date";
}

}  // namespace
}  // namespace gt
