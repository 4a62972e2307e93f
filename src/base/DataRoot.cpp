#include "base/DataRoot.h"

#include <cstdlib>
#include <filesystem>

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr const char* contents[] = {"behavior", "config", "layouts", "models", "motions", "scenes"};

/// The first folder that is missing in a root; empty if none is.
std::string missingIn(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : contents)
    if (!fs::is_directory(folder / name, ignored)) return name;
  return "";
}

bool isRoot(const fs::path& folder) {
  return missingIn(folder).empty();
}

Result<DataRoot> named(const std::string& folder, const char* where) {
  const std::string missing = missingIn(folder);
  if (missing.empty()) return DataRoot{folder};
  return Error{.file = folder,
               .field = where,
               .what = "is no data root: it has no folder '" + missing + "'"};
}

}  // namespace

DataRoot::DataRoot(const std::string& folder) {
  std::error_code failed;
  const fs::path absolute = fs::weakly_canonical(folder, failed);
  const fs::path relative = absolute.lexically_relative(fs::current_path(failed));
  const bool inside = !failed && !relative.empty() && *relative.begin() != "..";
  folder_ = inside ? relative.string() : failed ? folder : absolute.string();
  if (folder_ == ".") folder_.clear();
}

DataRoot::Places DataRoot::places(const std::string& option) {
  const char* variable = std::getenv("GT2003_ROOT");
  std::error_code ignored;
  return {option, variable ? variable : "", fs::read_symlink("/proc/self/exe", ignored).string(),
          GT_SOURCES};
}

Result<DataRoot> DataRoot::find(const Places& places) {
  if (!places.option.empty()) return named(places.option, "--root");
  if (!places.variable.empty()) return named(places.variable, "GT2003_ROOT");
  if (!places.program.empty()) {
    const fs::path programs = fs::path{places.program}.parent_path();
    if (const fs::path installed = programs.parent_path() / "share/gt2003"; isRoot(installed))
      return DataRoot{installed.string()};
    for (fs::path above = programs; above.has_relative_path(); above = above.parent_path())
      if (isRoot(above)) return DataRoot{above.string()};
  }
  if (!places.sources.empty() && isRoot(places.sources)) return DataRoot{places.sources};
  return Error{.field = "--root", .what = "no data root found; name it by --root or GT2003_ROOT"};
}

std::string DataRoot::path(const std::string& name) const {
  return folder_.empty() ? name : (fs::path{folder_} / name).string();
}

}  // namespace gt
