#pragma once
#include "debug/Debug.h"
#include "representations/modeling/BallModel.h"

namespace gt {

/// Draws the ball and the distance that it rolls within a second, if requested.
void draw(const BallModel& ball, Debug& debug);

/// Draws the team's ball and its uncertainty, if requested.
void draw(const TeamBallModel& ball, Debug& debug);

}  // namespace gt
