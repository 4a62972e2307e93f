#include "xabsl/formats/Convert.h"

#include <utility>

#include "xabsl/formats/Sources.h"
#include "xabsl/formats/text/SourceWriter.h"
#include "xabsl/language/Analyzer.h"

namespace xabsl {

namespace {

Conversion convert(const std::string& path, const FileReader& read, Form form,
                   const std::string& root) {
  Reporter reporter;
  syntax::Program program;
  readSources(path, read, program, reporter);
  requireAgents(program, reporter);
  // Only what is sound is converted: a writer need not ask what names stand for.
  Model model;
  if (!reporter.failed()) model = Analyzer(program, reporter).analyze();
  Conversion conversion;
  if (form != Form::text31 && root == "options.xml")
    reporter.fileError(root, "the file with the agents has the name of another file");
  if (!reporter.failed()) {
    const Dialect dialect = form == Form::xml21 ? Dialect::xabsl21 : Dialect::xabsl31;
    VirtualFiles files = form == Form::text31 ? writeText(program, root, reporter)
                                              : writeXml(program, model, dialect, root, reporter);
    if (!reporter.failed()) conversion.files = std::move(files);
  }
  conversion.diagnostics = reporter.take();
  return conversion;
}

}  // namespace

Conversion convert(const std::string& path, Form form, const std::string& root) {
  return convert(path, diskReader(), form, root);
}

Conversion convert(const std::string& path, const VirtualFiles& files, Form form,
                   const std::string& root) {
  return convert(path, readerOf(files), form, root);
}

}  // namespace xabsl
