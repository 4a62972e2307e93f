#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "xabsl/tools/server/Project.h"

namespace xabsl::server {

/// The errors of JSON-RPC and LSP with which a request is refused.
inline constexpr int invalidRequest = -32600, methodNotFound = -32601, invalidParameters = -32602,
                     parseError = -32700, notInitialized = -32002, requestFailed = -32803;

/// A position of LSP.
inline Position positionOf(const nlohmann::json& position) {
  return {position.at("line").get<int>(), position.at("character").get<int>()};
}

/// A range of LSP.
inline nlohmann::json range(Position begin, Position end) {
  const auto json = [](Position position) -> nlohmann::json {
    return {{"line", position.line}, {"character", position.character}};
  };
  return {{"start", json(begin)}, {"end", json(end)}};
}

/// The legend of the numbers of semantic tokens.
nlohmann::json semanticLegend();

}  // namespace xabsl::server
