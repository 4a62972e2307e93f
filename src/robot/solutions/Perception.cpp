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

void readTable(const ConfigurationFiles& files, Configuration& configuration, Findings& findings) {
  configuration.colorTable = std::make_shared<ColorTable64>();
  const std::string& told = files.paths.colorTable;
  auto table = readColorTable(told.empty() ? files.folder.path("coltable.c64") : told,
                              files.paths.colorOrder);
  if (table)
    *configuration.colorTable = std::move(*table);
  else
    findings.add(table.error());
}

void shareTable(const Configuration& configuration, const std::string&, Blackboard& blackboard) {
  blackboard.share(configuration.colorTable);
}

/// HSI ranges are made a color table (report J.6.2).
bool handleHsi(const Message& message, ModuleProcess& process, const ConfigurationFiles&) {
  if (!message.is<HsiColors>()) return false;
  HsiColors colors;
  const auto done = message.read(colors);
  if (done)
    *static_cast<ColorTable64*>(process.blackboard().own(representation<ColorTable64>())) =
        colors.table();
  process.answer(message, done);
  return true;
}

void readTsl(const ConfigurationFiles& files, Configuration& configuration, Findings& findings) {
  configuration.tslColors = std::make_shared<TslColors>();
  const std::string file = files.folder.path("coltable.tsl");
  if (!std::filesystem::exists(file)) return;
  auto colors = readTslColors(file);
  if (colors)
    *configuration.tslColors = std::move(*colors);
  else
    findings.add(colors.error());
}

void shareTsl(const Configuration& configuration, const std::string&, Blackboard& blackboard) {
  blackboard.share(configuration.tslColors);
}

}  // namespace

void addPerception(RobotModules& modules) {
  modules.parts.push_back({&representation<ColorTable64>(), readTable, shareTable, handleHsi});
  modules.parts.push_back({&representation<TslColors>(), readTsl, shareTsl});
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
