#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "streams/Json.h"

namespace gt {

/// A channel that a client of the Foxglove WebSocket protocol subscribes to, and the client's
/// number for this subscription.
struct FoxgloveSubscription {
  std::uint32_t id = 0, channel = 0;
};

/// A text message of a client of the Foxglove WebSocket protocol.
struct FoxgloveRequest {
  enum class Kind {
    subscribe,
    unsubscribe,
    getParameters,
    setParameters,
    subscribeParameters,
    unsubscribeParameters
  };
  struct Parameter {
    std::string name;
    Json value;
  };

  Kind kind = Kind::subscribe;
  std::vector<FoxgloveSubscription> subscriptions{};  ///< Of subscribe.
  std::vector<std::uint32_t> ids{};                   ///< Of unsubscribe.
  std::vector<std::string> names{};                   ///< Of parameters.
  std::vector<Parameter> parameters{};                ///< Of setParameters.
  std::string id{};  ///< Identifies the answer for the client; may be empty.
};

/// Parses a client's text. Returns an error if it is not a valid message, or requests something
/// that the server has not announced.
Result<FoxgloveRequest> parseFoxgloveRequest(std::string_view text);

/// A parameter as the protocol has it: its name, and its value, which configuration files write as
/// words, as a number, boolean, text, or list of these. Numbers have the protocol's only type of
/// numbers, whether they have to be whole or not.
Json parameterJson(const std::string& name, const std::string& words);
/// A value of the protocol as configuration files write it; a text is one word, whatever it holds.
/// An error if it is neither number, boolean, text nor a list of these.
Result<std::string> parameterText(const Json& value);

}  // namespace gt
