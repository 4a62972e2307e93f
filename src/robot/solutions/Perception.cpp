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

void addPerceptionSolutions(SolutionTable& table) {
  table.add<SensorDataProcessor, DefaultSensorDataProcessor>("Default");
  table.add<ImageProcessor, GT2003ImageProcessor>("GT2003");
  table.add<ImageProcessor, GridImageProcessor2>("GridImageProcessor2");
  table.add<ImageProcessor, GridImageProcessor3>("GridImageProcessor3");
  table.add<ImageProcessor, GridImageProcessorTSL>("GridImageProcessorTSL");
  table.add<ImageProcessor, LinesImageProcessor>("Lines");
  table.add<ImageProcessor, CheckerboardDetector>("CheckerboardDetector");
}

}  // namespace gt
