#pragma once
#include <libxml/tree.h>

namespace gt {

/// Adds people to a scene's MJCF: an audience in strong colors behind the outer wall, that nothing
/// meets, and the black legs of referees beside the walls of the field, which robots and balls run
/// into. The same number always gives the same people.
void addAudience(xmlNode* worldbody, int count);
void addReferees(xmlNode* worldbody, int count);

}  // namespace gt
