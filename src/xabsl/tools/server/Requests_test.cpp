#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "xabsl/tools/server/OpenText.h"

namespace xabsl::server {
namespace {

/// Names beside what is being typed lead to their declarations, and are offered.
TEST(Requests, KnowNamesInABrokenState) {
  std::string text = typedText;
  text.replace(text.find("if (ball.seen && @x > 2) goto run;"), 34, "if (ball.");
  text.replace(text.find("walking(\"Walking\") {"), 20, "walking(\"Wal");
  OpenText open{text};
  const auto at = [&](const std::string& piece) {
    const std::size_t place = text.find(piece);
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n');
    return OutlineJson{
        {"position", {{"line", line}, {"character", place - text.rfind('\n', place) - 1}}}};
  };
  const OutlineJson walk = open.ask("textDocument/definition", at("walk(x = @x"));
  EXPECT_EQ(walk["range"]["start"], at("walk {")["position"]);
  const OutlineJson offered = open.ask("textDocument/completion", at("memory = scaled"));
  std::vector<std::string> labels;
  for (const OutlineJson& item : offered) labels.push_back(item["label"]);
  EXPECT_THAT(labels, testing::IsSupersetOf({"walk", "stand", "search", "memory"}));
  EXPECT_THAT(labels, testing::Not(testing::Contains("")));
}

}  // namespace
}  // namespace xabsl::server
