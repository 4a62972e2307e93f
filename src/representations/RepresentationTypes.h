#pragma once
#include <span>

#include "framework/Representation.h"

namespace gt {

/// The types of all representations.
std::span<const RepresentationType* const> representationTypes();

}  // namespace gt
