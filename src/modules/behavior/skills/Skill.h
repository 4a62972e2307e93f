#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/skills/Movement.h"

namespace gt {

/// A skill that the behavior's options end in (report 3.8.2, 3.8.3); its parameters are members of
/// the class that is generated from behavior/skills/basic_behaviors.xabsl, angles in degrees, as
/// people write them in XABSL.
template <typename Declared>
class Skill : public Declared {
 public:
  explicit Skill(Movement& movement) : movement_{movement} {}

 protected:
  Movement& movement_;
};

}  // namespace gt
