#pragma once
#include "debug/Debug.h"
#include "representations/modeling/BallModel.h"

namespace gt {

/// Draws the ball and where it rolls within a second, if somebody asks for it.
void draw(const BallModel& ball, Debug& debug);

/// Draws the team's ball and how uncertain it is, if somebody asks for it.
void draw(const TeamBallModel& ball, Debug& debug);

}  // namespace gt
