#include "framework/RepresentationDefinition.h"
#include "network/Vocabulary.h"

namespace gt {

template const RepresentationType& representation<TypeDescription>();
template const RepresentationType& representation<TypeDescriptions>();

}  // namespace gt
