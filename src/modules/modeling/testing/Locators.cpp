#include "modules/modeling/testing/Locators.h"

#include "modules/modeling/selflocator/FusionSelfLocator.h"
#include "modules/modeling/selflocator/KalmanSelfLocator.h"
#include "modules/modeling/selflocator/LinesSelfLocator.h"

namespace gt {
namespace {

template <typename Solution>
LocatorKind kind(std::string name, bool usesEdges) {
  return {std::move(name), usesEdges, [](std::uint64_t seed) {
            return std::make_unique<LocatorOf<Solution>>(typename Solution::Parameters{}, seed);
          }};
}

}  // namespace

std::vector<LocatorKind> locatorKinds() {
  return {kind<SingleLandmarkSelfLocator>("singlelandmark", false),
          kind<MonteCarloSelfLocator>("montecarlo", false),
          kind<FusionSelfLocator>("fusion", false),
          kind<LinesSelfLocator>("lines", true),
          kind<GT2003SelfLocator>("gt2003", true),
          kind<Fusion2003SelfLocator>("fusion2003", true),
          kind<KalmanSelfLocator>("kalman", true)};
}

}  // namespace gt
