#include <cstdlib>
#include <string>

#include "AllForms.h"
#include "Fuzz.h"
#include "xabsl/formats/Compile.h"
#include "xabsl/formats/text/Formatter.h"
#include "xabsl/language/Reporter.h"

/// Whatever is text is formatted once and for all; what compiles means the same then.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text{gt::textOf(data, size)};
  gt::goThroughAllForms("fuzz.xabsl", {{"fuzz.xabsl", text}});
  xabsl::Reporter reporter;
  const auto formatted = xabsl::format(reporter.addFile("fuzz.xabsl", text), text, reporter);
  if (!formatted) return 0;
  if (xabsl::format(0, *formatted, reporter) != formatted) std::abort();
  const xabsl::Compilation before = xabsl::compile("fuzz.xabsl", {{"fuzz.xabsl", text}});
  if (!before.behavior) return 0;
  if (gt::codeOf(xabsl::compile("fuzz.xabsl", {{"fuzz.xabsl", *formatted}})) != gt::codeOf(before))
    std::abort();
  return 0;
}
