#include "modules/perception/DefaultSensorDataProcessor.h"
#include "modules/perception/GT2003ImageProcessor.h"
#include "modules/perception/Tasks.h"
#include "robot/Solutions.h"

namespace gt {

void addPerceptionSolutions(SolutionTable& table) {
  table.add<SensorDataProcessor, DefaultSensorDataProcessor>("Default");
  table.add<ImageProcessor, GT2003ImageProcessor>("GT2003");
}

}  // namespace gt
