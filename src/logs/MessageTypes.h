#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "framework/Representation.h"

namespace gt {

/// The types of all messages between robots and their tools: all representations, requests and
/// their answers, drawings, plots, texts, times, and self-descriptions of processes.
const std::vector<const RepresentationType*>& messageTypes();

/// Returns a type by its message id or name; null if it is unknown.
const RepresentationType* messageType(std::uint32_t id);
const RepresentationType* messageType(std::string_view name);

}  // namespace gt
