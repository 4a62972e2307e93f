#include <algorithm>
#include <cstdio>
#include <type_traits>

#include "base/File.h"
#include "framework/Layout.h"
#include "modules/behavior/Tasks.h"
#include "modules/modeling/Tasks.h"
#include "modules/motion/Tasks.h"
#include "modules/perception/Tasks.h"

namespace {

using namespace gt;

/// An area of modules: the function that adds its solutions (robot/Areas.h), and its tasks.
struct Area {
  std::string function;
  std::vector<std::string_view> tasks;
};

template <typename... T>
Area area(const std::string& function, std::type_identity<std::tuple<T...>>) {
  return {function, {typeName<T>()...}};
}

/// Writes Process.h's functions for a process: with the areas whose tasks it runs in some layout.
Result<void> generate(const std::string& process, const std::string& file,
                      const std::vector<std::string>& layouts) {
  std::vector<std::string> tasks;
  for (const std::string& path : layouts) {
    const auto layout = loadLayout(path);
    if (!layout) return layout.error();
    for (const ProcessLayout& form : layout->processes)
      if (form.name == process)
        for (const auto& group : form.groups)
          std::ranges::copy(group.tasks, std::back_inserter(tasks));
  }
  std::string additions;
  for (const Area& a : {area("addPerception", std::type_identity<PerceptionTasks>{}),
                        area("addModeling", std::type_identity<ModelingTasks>{}),
                        area("addBehavior", std::type_identity<BehaviorTasks>{}),
                        area("addMotion", std::type_identity<MotionTasks>{})})
    if (std::ranges::find_first_of(a.tasks, tasks) != a.tasks.end())
      additions += "  " + a.function + "(modules);\n";
  return writeFile(file,
                   "#include \"Process.h\"\n\nnamespace gt {\n\n"
                   "const char* const processName = \"" +
                       process +
                       "\";\n\n"
                       "void addProcessModules([[maybe_unused]] RobotModules& modules) {\n" +
                       additions + "}\n\n}  // namespace gt\n");
}

}  // namespace

/// gtrobot_generate PROCESS OUTPUT.cpp LAYOUT...: the source of a process's program.
int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const auto done = generate(argv[1], argv[2], {argv + 3, argv + argc});
  if (!done) std::fprintf(stderr, "%s\n", done.error().text().c_str());
  return done ? 0 : 2;
}
