#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "framework/Representation.h"

namespace gt {

/// The types of all messages that robots and their tools exchange: all representations, requests and
/// their answers, drawings, plots, texts, times, and what processes report about themselves.
const std::vector<const RepresentationType*>& messageTypes();

/// A type by its message id or by its name; null if it is unknown.
const RepresentationType* messageType(std::uint32_t id);
const RepresentationType* messageType(std::string_view name);

}  // namespace gt
