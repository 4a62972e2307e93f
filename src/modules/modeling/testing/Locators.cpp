#include "modules/modeling/testing/Locators.h"

#include "modules/modeling/selflocator/FusionSelfLocator.h"
#include "modules/modeling/selflocator/KalmanSelfLocator.h"
#include "modules/modeling/selflocator/LinesSelfLocator.h"

namespace gt {
namespace {

template <typename Solution>
LocatorKind kind(std::string name, std::string solution, bool usesEdges) {
  return {std::move(name), std::move(solution), usesEdges, [](std::uint64_t seed) {
            return std::make_unique<LocatorOf<Solution>>(typename Solution::Parameters{}, seed);
          }};
}

}  // namespace

std::vector<LocatorKind> locatorKinds() {
  return {kind<SingleLandmarkSelfLocator>("singlelandmark", "SingleLandmark", false),
          kind<MonteCarloSelfLocator>("montecarlo", "MonteCarlo", false),
          kind<FusionSelfLocator>("fusion", "Fusion", false),
          kind<LinesSelfLocator>("lines", "Lines", true),
          kind<GT2003SelfLocator>("gt2003", "GT2003", true),
          kind<Fusion2003SelfLocator>("fusion2003", "Fusion2003", true),
          kind<KalmanSelfLocator>("kalman", "Kalman", true)};
}

}  // namespace gt
