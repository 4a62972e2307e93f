#include <algorithm>
#include <filesystem>

#include "modules/motion/specialactions/MotionNetLoader.h"
#include "robot/Solutions.h"
#include "streams/Config.h"

namespace gt {
namespace {

void read(const ConfigurationPart&, Configuration& configuration, Findings& findings) {
  configuration.set(MotionNet{});
  const ConfigurationFiles& files = configuration.files;
  const auto compilation = motionnet::compileFolder(files.paths.motions, motionRules());
  for (const motionnet::Diagnostic& error : compilation.errors)
    findings.add(
        {.file = error.file, .line = error.line, .field = error.field, .what = error.message});
  if (!compilation) return;
  auto net = motionNetOf(compilation.net, files.paths.motions);
  if (!net) return findings.add(net.error());
  KickTable kicks;
  const std::string table = files.folder.path("kicks.cfg");
  if (std::filesystem::exists(table))
    if (auto read = readConfig(table, kicks); !read) findings.add(read.error());
  net->take(kicks);
  configuration.set(*std::move(net));
}

}  // namespace

void addMotionNet(RobotModules& modules) {
  const ConfigurationPart part{.type = &representation<MotionNet>(), .read = read};
  if (std::ranges::find(modules.parts, part.type, &ConfigurationPart::type) == modules.parts.end())
    modules.parts.push_back(part);
}

}  // namespace gt
