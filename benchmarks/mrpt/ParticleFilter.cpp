// MRPT's particle filter, to compare our self-locators with: two beacons whose distances are
// measured, a step of odometry, and the mean pose in each update.
#include <mrpt/bayes/CParticleFilter.h>
#include <mrpt/maps/CBeaconMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CActionRobotMovement2D.h>
#include <mrpt/obs/CObservationBeaconRanges.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/slam/CMonteCarloLocalization2D.h>

#include <array>
#include <cmath>
#include <vector>

#include "benchmarks/Parts.h"

namespace gt {
namespace {

constexpr std::array<std::array<double, 2>, 2> beacons{{{2.1, 1.4}, {2.1, -1.4}}};  // m
constexpr double cameraHeight = 0.2, beaconHeight = 0.3;                            // m

mrpt::maps::CBeaconMap::Ptr makeMap() {
  auto map = mrpt::maps::CBeaconMap::Create();
  for (std::size_t i = 0; i < beacons.size(); ++i) {
    mrpt::maps::CBeacon beacon;
    beacon.m_ID = static_cast<std::int64_t>(i);
    beacon.m_typePDF = mrpt::maps::CBeacon::pdfGauss;
    beacon.m_locationGauss.mean = mrpt::poses::CPoint3D(beacons[i][0], beacons[i][1], beaconHeight);
    beacon.m_locationGauss.cov.setIdentity();
    beacon.m_locationGauss.cov *= 1e-6;
    map->push_back(beacon);
  }
  return map;
}

/// What a robot measures that walks on a circle, over and over again.
std::vector<mrpt::obs::CSensoryFrame> measureOnCircle(int steps) {
  std::vector<mrpt::obs::CSensoryFrame> frames;
  for (int i = 1; i <= steps; ++i) {
    const double angle = 2 * M_PI * i / steps;
    auto ranges = mrpt::obs::CObservationBeaconRanges::Create();
    ranges->stdError = 0.05f;
    for (std::size_t k = 0; k < beacons.size(); ++k) {
      mrpt::obs::CObservationBeaconRanges::TMeasurement m;
      m.beaconID = static_cast<std::int32_t>(k);
      m.sensorLocationOnRobot = mrpt::poses::CPoint3D(0, 0, cameraHeight);
      m.sensedDistance = static_cast<float>(std::hypot(beacons[k][0] - std::sin(angle),
                                                       beacons[k][1] + std::cos(angle),
                                                       beaconHeight - cameraHeight));
      ranges->sensedData.push_back(m);
    }
    frames.emplace_back();
    frames.back().insert(ranges);
  }
  return frames;
}

void mrptFilter(benchmark::State& state, std::size_t samples) {
  constexpr int steps = 1000;
  const std::vector<mrpt::obs::CSensoryFrame> frames = measureOnCircle(steps);
  mrpt::obs::CActionRobotMovement2D movement;
  mrpt::obs::CActionRobotMovement2D::TMotionModelOptions model;
  model.modelSelection = mrpt::obs::CActionRobotMovement2D::mmGaussian;
  movement.computeFromOdometry(mrpt::poses::CPose2D(2 * M_PI / steps, 0, 2 * M_PI / steps), model);
  mrpt::obs::CActionCollection actions;
  actions.insert(movement);

  mrpt::slam::CMonteCarloLocalization2D samplesSet(samples);
  samplesSet.options.metricMap = makeMap();
  samplesSet.resetDeterministic(mrpt::math::TPose2D(0, -1, 0), samples);
  mrpt::bayes::CParticleFilter filter;
  filter.m_options.PF_algorithm = mrpt::bayes::CParticleFilter::pfStandardProposal;
  filter.m_options.resamplingMethod = mrpt::bayes::CParticleFilter::prSystematic;
  filter.m_options.adaptiveSampleSize = false;
  mrpt::poses::CPose2D mean;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    filter.executeOn(samplesSet, &actions, &frames[next++ % steps]);
    samplesSet.getMean(mean);
  }
  benchmark::DoNotOptimize(mean);
}

BENCHMARK_CAPTURE(mrptFilter, few, 30)->Name("speed.localization.mrpt.30")->Apply(inMicroseconds);
BENCHMARK_CAPTURE(mrptFilter, some, 100)
    ->Name("speed.localization.mrpt.100")
    ->Apply(inMicroseconds);
BENCHMARK_CAPTURE(mrptFilter, many, 1000)
    ->Name("speed.localization.mrpt.1000")
    ->Apply(inMicroseconds);

}  // namespace
}  // namespace gt
