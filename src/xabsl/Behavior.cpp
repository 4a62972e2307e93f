#include "xabsl/Behavior.h"

#include "xabsl/Analyzer.h"
#include "xabsl/Reporter.h"
#include "xabsl/Sources.h"
#include "xabsl/Syntax.h"
#include "xabsl/Warnings.h"

namespace xabsl {

namespace {

Compilation compile(const std::string& path, const FileReader& read) {
  Reporter reporter;
  syntax::Program program;
  readSources(path, read, program, reporter);
  Compilation compilation;
  if (!reporter.failed()) {
    auto model = std::make_shared<Model>(Analyzer(program, reporter).analyze());
    if (!reporter.failed()) {
      warnAbout(*model, reporter);
      compilation.behavior.emplace(std::move(model));
    }
  }
  compilation.diagnostics = reporter.take();
  return compilation;
}

}  // namespace

Compilation compile(const std::string& path) {
  return compile(path,
                 [](const std::string& name, std::string& text) { return readFile(name, text); });
}

Compilation compile(const std::string& path, const VirtualFiles& files) {
  return compile(path, readerOf(files));
}

}  // namespace xabsl
