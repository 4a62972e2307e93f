#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "streams/Json.h"

namespace gt {

/// A channel that a client of the Foxglove WebSocket protocol wants, and the number by which it
/// knows what comes.
struct FoxgloveSubscription {
  std::uint32_t id = 0, channel = 0;
};

/// What a client of the Foxglove WebSocket protocol sends as text.
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
  std::string id{};  ///< By which the client recognizes the answer; may be empty.
};

/// Reads a client's text. Returns an error if it is no such message, or asks for something that the
/// server has not announced.
Result<FoxgloveRequest> parseFoxgloveRequest(std::string_view text);

/// A parameter as the protocol has it: its name, and its value, which configuration files write as
/// words, as a number, boolean, text, or list of these. Numbers have the protocol's only type of
/// numbers, whether they have to be whole or not.
Json parameterJson(const std::string& name, const std::string& words);
/// A value of the protocol as configuration files write it; a text is one word, whatever it holds.
/// An error if it is neither number, boolean, text nor a list of these.
Result<std::string> parameterText(const Json& value);

}  // namespace gt
