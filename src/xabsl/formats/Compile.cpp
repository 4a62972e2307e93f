#include "xabsl/formats/Compile.h"

#include "xabsl/formats/Sources.h"
#include "xabsl/language/Analyzer.h"
#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/Warnings.h"

namespace xabsl {

Compilation compile(const std::string& path, const FileReader& read, Dialect text) {
  Reporter reporter;
  syntax::Program program;
  program.dialect = text;
  readSources(path, read, program, reporter);
  requireAgents(program, reporter);
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

Compilation compile(const std::string& path, Dialect text) {
  return compile(path, diskReader(), text);
}

Compilation compile(const std::string& path, const VirtualFiles& files, Dialect text) {
  return compile(path, readerOf(files), text);
}

}  // namespace xabsl
