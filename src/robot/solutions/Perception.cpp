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

/// Sets what was read; errors go to the findings.
template <typename T>
void set(Result<T> read, Configuration& configuration, Findings& findings) {
  if (!read) findings.add(read.error());
  configuration.set(read ? *std::move(read) : T{});
}

void readHsi(const ConfigurationPart&, Configuration& configuration, Findings& findings) {
  if (configuration.find<HsiColors>()) return;
  const std::string file = hsiFile(configuration.files);
  set(file.empty() ? HsiColors{} : readHsiColors(file), configuration, findings);
}

void readTable(const ConfigurationPart& part, Configuration& configuration, Findings& findings) {
  readHsi(part, configuration, findings);
  const ConfigurationFiles& files = configuration.files;
  const std::string& given = files.paths.colorTable;
  if (!hsiFile(files).empty())
    configuration.set(configuration.get<HsiColors>().table());
  else
    set(readColorTable(given.empty() ? files.folder.path(part.file) : given,
                       files.paths.colorOrder),
        configuration, findings);
}

void readTsl(const ConfigurationPart& part, Configuration& configuration, Findings& findings) {
  const std::string file = configuration.files.folder.path(part.file);
  const bool exists = std::filesystem::exists(file);
  set(exists ? readTslColors(file) : TslColors{}, configuration, findings);
}

}  // namespace

void addPerception(RobotModules& modules) {
  const auto add = [&](const ConfigurationPart& part) { modules.parts.push_back(part); };
  add({.type = &representation<ColorTable64>(),
       .file = "coltable.c64",
       .read = readTable,
       .changed = [](Blackboard& b) { b.get<HsiColors>() = {}; },
       .text =
           [](const void* value) {
             return colorTableBytes(*static_cast<const ColorTable64*>(value));
           }});
  // Behind the table, which may be made of these ranges (report J.6.2); one by itself has none.
  add({.type = &representation<HsiColors>(),
       .file = "coltable.hsi",
       .read = readHsi,
       .share = [](const Configuration& c, const std::string&,
                   Blackboard& b) { b.get<HsiColors>() = c.get<HsiColors>(); },
       .changed =
           [](Blackboard& b) {
             *static_cast<ColorTable64*>(b.own(representation<ColorTable64>())) =
                 b.get<HsiColors>().table();
           },
       .text = [](const void* value) -> std::string {
         const auto& colors = *static_cast<const HsiColors*>(value);
         const bool any = !std::ranges::all_of(colors.ranges.values, &HsiRange::empty);
         return any ? hsiText(colors) : std::string{};
       }});
  add({.type = &representation<TslColors>(),
       .file = "coltable.tsl",
       .read = readTsl,
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
