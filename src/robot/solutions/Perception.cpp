#include <algorithm>
#include <filesystem>

#include "colors/HsiColors.h"
#include "colors/TslColors.h"
#include "framework/ModuleProcess.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/calibration/CheckerboardDetector.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/processors/GridImageProcessor2.h"
#include "modules/perception/processors/GridImageProcessor3.h"
#include "modules/perception/processors/GridImageProcessorTSL.h"
#include "modules/perception/processors/LinesImageProcessor.h"
#include "robot/Solutions.h"

namespace gt {

namespace {

/// Of the folders with a color table the last wins, and there ranges win over a table. Empty if it
/// is made of no ranges.
std::string hsiFile(const ConfigurationFiles& files) {
  if (!files.paths.colorTable.empty()) return {};
  const auto ranges = files.folder.paths("coltable.hsi"),
             tables = files.folder.paths("coltable.c64");
  for (std::size_t i = ranges.size(); i-- > 0;) {
    if (std::filesystem::exists(ranges[i])) return ranges[i];
    if (std::filesystem::exists(tables[i])) return {};
  }
  return {};
}

/// Takes what was read; errors go to the findings.
template <typename T>
void take(Result<T> read, T& value, Findings& findings) {
  if (read)
    value = std::move(*read);
  else
    findings.add(read.error());
}

void readHsi(const ConfigurationFiles& files, Configuration& configuration, Findings& findings) {
  if (configuration.hsiColors) return;
  configuration.hsiColors = std::make_shared<HsiColors>();
  if (const std::string file = hsiFile(files); !file.empty())
    take(readHsiColors(file), *configuration.hsiColors, findings);
}

void readTable(const ConfigurationFiles& files, Configuration& configuration, Findings& findings) {
  configuration.colorTable = std::make_shared<ColorTable64>();
  readHsi(files, configuration, findings);
  const std::string& given = files.paths.colorTable;
  if (!hsiFile(files).empty())
    *configuration.colorTable = configuration.hsiColors->table();
  else
    take(readColorTable(given.empty() ? files.folder.path("coltable.c64") : given,
                        files.paths.colorOrder),
         *configuration.colorTable, findings);
}

void readTsl(const ConfigurationFiles& files, Configuration& configuration, Findings& findings) {
  configuration.tslColors = std::make_shared<TslColors>();
  const std::string file = files.folder.path("coltable.tsl");
  if (!std::filesystem::exists(file)) return;
  take(readTslColors(file), *configuration.tslColors, findings);
}

}  // namespace

void addPerception(RobotModules& modules) {
  const auto add = [&](const ConfigurationPart& part) { modules.parts.push_back(part); };
  add({.type = &representation<ColorTable64>(),
       .read = readTable,
       .share = [](const Configuration& c, const std::string&,
                   Blackboard& b) { b.share(c.colorTable); },
       .changed = [](Blackboard& b) { b.get<HsiColors>() = {}; },
       .file = "coltable.c64",
       .text =
           [](const void* value) {
             return colorTableBytes(*static_cast<const ColorTable64*>(value));
           }});
  // Behind the table, which may be made of these ranges (report J.6.2); one by itself has none.
  add({.type = &representation<HsiColors>(),
       .read = readHsi,
       .share = [](const Configuration& c, const std::string&,
                   Blackboard& b) { b.get<HsiColors>() = *c.hsiColors; },
       .changed =
           [](Blackboard& b) {
             *static_cast<ColorTable64*>(b.own(representation<ColorTable64>())) =
                 b.get<HsiColors>().table();
           },
       .file = "coltable.hsi",
       .text = [](const void* value) -> std::string {
         const auto& colors = *static_cast<const HsiColors*>(value);
         const bool any = !std::ranges::all_of(colors.ranges.values, &HsiRange::empty);
         return any ? hsiText(colors) : std::string{};
       }});
  add({.type = &representation<TslColors>(),
       .read = readTsl,
       .share = [](const Configuration& c, const std::string&,
                   Blackboard& b) { b.share(c.tslColors); },
       .file = "coltable.tsl",
       .text = [](const void* value) { return tslText(*static_cast<const TslColors*>(value)); }});
  SolutionTable& table = modules.solutions;
  table.add<SensorDataProcessor, DefaultSensorDataProcessor>("Default");
  table.add<ImageProcessor, GT2003ImageProcessor>("GT2003");
  table.add<ImageProcessor, GridImageProcessor2>("GridImageProcessor2");
  table.add<ImageProcessor, GridImageProcessor3>("GridImageProcessor3");
  table.add<ImageProcessor, GridImageProcessorTSL>("GridImageProcessorTSL");
  table.add<ImageProcessor, LinesImageProcessor>("Lines");
  table.add<ImageProcessor, CheckerboardDetector>("CheckerboardDetector");
}

}  // namespace gt
