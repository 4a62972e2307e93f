#include "xabsl/language/References.h"

#include <gtest/gtest.h>

#include <string>

#include "xabsl/formats/Sources.h"
#include "xabsl/language/Analyzer.h"

namespace xabsl {
namespace {

/// `line:column text`, with `!` where something is declared, in the order of the places.
std::string referencesIn(const std::string& text, const Entity& entity) {
  Reporter reporter;
  syntax::Program program;
  const VirtualFiles files = {{"main.xabsl", text}};
  readSources("main.xabsl", readerOf(files), program, reporter);
  References references;
  Analyzer(program, reporter, &references).analyze();
  EXPECT_FALSE(reporter.failed());
  std::string all;
  for (const Reference& reference : references.all())
    if (reference.entity == entity)
      all += std::to_string(reference.location.line) + ":" +
             std::to_string(reference.location.column) + " " + std::string(reference.text) +
             (reference.declares ? "! " : " ");
  return all;
}

TEST(References, FindAllPlacesOfAName) {
  const std::string text =
      "agent a(\"A\", main);\n"
      "namespace n(\"N\") { enum mode output { slow, mode.fast }; enum mode output gait; }\n"
      "option main { initial state s {\n"
      "  action { gait = mode.fast; child(p = true); } } }\n"
      "option child { bool @p; initial state s { decision { if (@p) stay; else goto s; }\n"
      "  action { gait = slow; } } }";
  EXPECT_EQ(referencesIn(text, {Entity::Kind::option, 0}), "3:8 main! 1:14 main ");
  EXPECT_EQ(referencesIn(text, {Entity::Kind::symbol, 0}), "2:75 gait! 4:12 gait 6:12 gait ");
  EXPECT_EQ(referencesIn(text, {Entity::Kind::element, 0, 1}), "2:50 fast! 4:24 fast ");
  EXPECT_EQ(referencesIn(text, {Entity::Kind::optionParameter, 1, 0}), "5:22 p! 4:36 p 5:59 p ");
  EXPECT_EQ(referencesIn(text, {Entity::Kind::state, 1}), "5:39 s! 5:78 s ");
}

}  // namespace
}  // namespace xabsl
