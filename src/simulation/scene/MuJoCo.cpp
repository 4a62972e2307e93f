#include "simulation/scene/MuJoCo.h"

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace gt {
namespace {

/// The point at which to continue after an error of MuJoCo, and its message. MuJoCo ends the
/// process unless its error handler never returns.
struct ErrorTrap {
  std::jmp_buf back;
  char message[1000] = "";
};
thread_local ErrorTrap* trap = nullptr;

void onError(const char* message) {
  if (!trap) std::abort();  // outside a guarded call only a bug of ours gets here
  std::strncpy(trap->message, message, sizeof trap->message - 1);
  std::longjmp(trap->back, 1);
}

mjModel* compileGuarded(const mjVFS* files, ErrorTrap& guard) {
  trap = &guard;
  if (setjmp(guard.back) != 0) {
    trap = nullptr;
    return nullptr;
  }
  mjModel* model = mj_loadXML("scene.xml", files, guard.message, sizeof guard.message);
  trap = nullptr;
  return model;
}

}  // namespace

Result<Model> compileModel(const std::string& mjcf, const std::string& file) {
  static std::once_flag once;
  std::call_once(once, [] {
    mju_user_error = onError;
    mju_user_warning = [](const char*) {};
  });
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(mjcf.size())) != 0)
    return Error{.file = file, .what = "the model is too large"};
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "scene.xml")], mjcf.data(), mjcf.size());
  ErrorTrap guard;
  Model model{compileGuarded(files.get(), guard)};
  mj_deleteVFS(files.get());
  if (model) return model;
  std::string what = guard.message;
  for (char& c : what)
    if (c == '\n') c = ' ';
  // "Element 'geom', line 4, column 5" or "Object name = a, id = 1, line = 4, column = -1".
  const auto place = what.find(", line ");
  const auto line = what.find_first_of("0123456789", place);
  what.resize(std::min(place, what.size()));
  while (what.ends_with(' ')) what.pop_back();
  return Error{.file = file,
               .line = place == std::string::npos ? 0 : std::atoi(guard.message + line),
               .what = "MuJoCo: " + what};
}

std::string nameOf(const mjModel& model, mjtObj type, int id) {
  const char* name = mj_id2name(&model, type, id);
  return name ? name : "";
}

std::vector<double> customNumbers(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_NUMERIC, name.c_str());
  if (id < 0) return {};
  const mjtNum* first = model.numeric_data + model.numeric_adr[id];
  return {first, first + model.numeric_size[id]};
}

Model copyModel(const mjModel& model) {
  return Model{mj_copyModel(nullptr, &model)};
}

ModelData makeData(const mjModel& model) {
  return ModelData{mj_makeData(&model)};
}

}  // namespace gt
