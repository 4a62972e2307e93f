#pragma once

#include <cstdlib>
#include <string>

#include "xabsl/formats/Compile.h"
#include "xabsl/formats/Convert.h"
#include "xabsl/formats/intermediate/IntermediateCode.h"

namespace gt {

/// Intermediate code without its first line, which is a comment for people.
inline std::string codeOf(const xabsl::Compilation& compilation) {
  if (!compilation.behavior) std::abort();
  const xabsl::IntermediateCode code = xabsl::writeIntermediateCode(compilation.behavior->model());
  if (!code.text) std::abort();
  return code.text->substr(code.text->find('\n'));
}

/// Whatever compiles can be written in each form that can express it, and means the same there.
inline void goThroughAllForms(const std::string& path, const xabsl::VirtualFiles& files) {
  using xabsl::Form;
  const xabsl::Compilation source = xabsl::compile(path, files);
  if (!source.behavior) return;
  const std::string code = codeOf(source);
  for (const Form form : {Form::xml21, Form::xml31, Form::text31}) {
    const std::string root = form == Form::text31 ? "new-agents.xabsl" : "new-agents.xml";
    const xabsl::Conversion conversion = xabsl::convert(path, files, form, root);
    if (!conversion.files) continue;
    const std::string written = codeOf(xabsl::compile(root, *conversion.files));
    // In 2.1 actions have an order of their own; its names may be others in text.
    const bool old =
        form == Form::xml21 || source.behavior->model().dialect == xabsl::Dialect::xabsl21;
    if (!old && written != code) std::abort();
  }
}

}  // namespace gt
