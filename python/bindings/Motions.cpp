#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "Failure.h"
#include "Tools.h"
#include "Values.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "motionnet/Listing.h"

namespace gt::python {
namespace {

using Sources = std::vector<std::pair<std::string, std::string>>;

/// The net, or None, and what is wrong: file, line, field, message.
nb::tuple resultOf(const motionnet::Compilation& compilation, const std::string& source) {
  nb::list errors;
  for (const motionnet::Diagnostic& error : compilation.errors)
    errors.append(nb::make_tuple(error.file, error.line, error.field, error.message));
  if (!compilation) return nb::make_tuple(nb::none(), errors);
  const auto net = motionNetOf(compilation.net, source);
  if (net) return nb::make_tuple(toPython(valueOf(*net)), errors);
  errors.append(
      nb::make_tuple(net.error().file, net.error().line, net.error().field, net.error().what));
  return nb::make_tuple(nb::none(), errors);
}

}  // namespace

void bindMotions(nb::module_& module) {
  module.def("_compile_motions", [](const Sources& sources) {
    std::vector<motionnet::Source> files;
    for (const auto& [file, text] : sources) files.push_back({file, text});
    return resultOf(motionnet::compile(files, motionRules()), "files in memory");
  });
  module.def("_compile_motion_folder", [](const std::string& folder) {
    return resultOf(motionnet::compileFolder(folder, motionRules()), folder);
  });
  module.def("_list_motions",
             [](const std::vector<std::string>& names) { return motionnet::listing(names); });
}

}  // namespace gt::python
