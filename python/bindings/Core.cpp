#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "Environments.h"
#include "Failure.h"
#include "Jobs.h"
#include "Logs.h"
#include "Match.h"
#include "Modules.h"
#include "Root.h"
#include "Tools.h"
#include "Types.h"
#include "base/File.h"

namespace gt::python {
namespace {

/// What an error quotes may be no UTF-8.
nanobind::str textOf(const std::string& bytes) {
  return nanobind::steal<nanobind::str>(PyUnicode_DecodeUTF8(
      bytes.data(), static_cast<Py_ssize_t>(bytes.size()), "backslashreplace"));
}

void raise(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Failure& failure) {
    const Error& e = failure.error;
    const nanobind::object type = nanobind::module_::import_("gt2003._error").attr("Error");
    const nanobind::object error = type(textOf(e.what), textOf(e.file), e.line, textOf(e.field));
    PyErr_SetObject(type.ptr(), error.ptr());
  }
}

}  // namespace

DataRoot findRoot(const std::string& root) {
  auto places = DataRoot::places(root);
  // The package's own data lie in its folder data; below the sources these are found.
  const nanobind::object package = nanobind::module_::import_("gt2003").attr("__path__")[0];
  places.program = nanobind::cast<std::string>(package) + "/data/program";
  return orThrow(DataRoot::find(places));
}

}  // namespace gt::python

NB_MODULE(_core, module) {
  module.doc() = "The compiled part of gt2003.";
  nanobind::register_exception_translator(&gt::python::raise);
  gt::python::bindTypes(module);
  module.def("_data_path",
             [](const std::string& path) { return gt::python::findRoot("").path(path); });
  module.def("_write_file", [](const std::string& path, const nanobind::bytes& content) {
    gt::python::orThrow(gt::writeFile(path, {content.c_str(), content.size()}));
  });
  gt::python::bindColors(module);
  gt::python::bindLogs(module);
  gt::python::bindMatch(module);
  gt::python::bindModules(module);
  gt::python::bindJobs(module);
  gt::python::bindMotions(module);
  gt::python::bindXabsl(module);
  gt::python::bindEnvironments(module);
}
