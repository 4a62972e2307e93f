#pragma once
#include <libxml/tree.h>

#include "base/Random.h"

namespace gt {

/// Adds people to a scene's MJCF: an audience in strong colors behind the outer wall, which nothing
/// collides with, and the black legs of referees beside the walls of the field, which robots and
/// balls collide with. The places of the audience are random; one in eight wears each color.
void addAudience(xmlNode* worldbody, int count, Random random);
void addReferees(xmlNode* worldbody, int count);

}  // namespace gt
