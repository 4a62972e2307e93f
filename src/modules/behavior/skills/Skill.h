#pragma once
#include "modules/behavior/SoccerSymbols.h"
#include "modules/behavior/skills/Movement.h"

namespace gt {

/// A basic behavior, called by the behavior's options (report 3.8.2, 3.8.3). Its parameters are
/// members of the class that is generated from behavior/skills/basic_behaviors.xabsl; angles are in
/// degrees, as in XABSL.
template <typename Declared>
class Skill : public Declared {
 public:
  explicit Skill(Movement& movement) : movement_{movement} {}

 protected:
  Movement& movement_;
};

}  // namespace gt
