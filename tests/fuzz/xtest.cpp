#include <algorithm>
#include <string>

#include "Fuzz.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/tools/testing/TestRunner.h"

/// The behavior that the tests in the corpus are about, without its surroundings.
const char* const behavior = R"(
namespace symbols("") {
  enum head_mode { search_for_ball, look_at_ball };
  float input ball.distance; float input ball.time_since_seen; float input ball.angle;
  float input abs(float value;); enum head_mode output head.mode;
}
namespace behaviors("") { behavior walk { float x; float rotation; } behavior stand {} }
agent player("", play);
option play {
  initial state search {
    decision { if (ball.time_since_seen < 100) goto approach; else stay; }
    action { head.mode = search_for_ball; walk(rotation = 1.5); } }
  state approach { decision { if (action_done) goto search; else stay; }
                   action { go_to_ball(speed = 100); } } }
option go_to_ball {
  float @speed;
  initial state straight { decision { if (abs(value = ball.distance) < 150) goto reached; else stay; }
                           action { walk(x = @speed); } }
  target state reached { action { stand(); } } }
)";

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace xabsl;
  static const Behavior compiled = *compile("a.xabsl", {{"a.xabsl", behavior}}).behavior;
  const std::string text{gt::textOf(data, size)};
  if (text.find("replay") != text.npos) return 0;  // would read other files
  std::vector<Diagnostic> diagnostics;
  const TestFile file = parseTests("fuzz.xtest", text, diagnostics);
  if (fails(diagnostics)) return 0;
  // Each may run for as many cycles as are allowed.
  for (std::size_t i = 0; i < std::min<std::size_t>(file.tests.size(), 2); ++i)
    runTest(compiled, file, file.tests[i]);
  return 0;
}
