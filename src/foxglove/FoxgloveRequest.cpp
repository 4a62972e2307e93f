#include "foxglove/FoxgloveRequest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/Lines.h"
#include "base/Number.h"

namespace gt {
namespace {

using Kind = FoxgloveRequest::Kind;

/// Of a list. Eight robots have some 5000 parameters.
constexpr std::size_t mostElements = 20'000;

constexpr std::array<std::pair<std::string_view, Kind>, 6> operations{{
    {"subscribe", Kind::subscribe},
    {"unsubscribe", Kind::unsubscribe},
    {"getParameters", Kind::getParameters},
    {"setParameters", Kind::setParameters},
    {"subscribeParameterUpdates", Kind::subscribeParameters},
    {"unsubscribeParameterUpdates", Kind::unsubscribeParameters},
}};

Error wrong(std::string field, std::string what) {
  return {.file = "client", .field = std::move(field), .what = std::move(what)};
}

std::optional<std::uint32_t> number(const Json& json) {
  if (!json.is_number_unsigned()) return std::nullopt;
  const auto value = json.get<std::uint64_t>();
  if (value > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(value);
}

/// A member of an object; null if it is not there.
const Json& member(const Json& json, const char* name) {
  static const Json none;
  if (!json.is_object()) return none;
  const auto found = json.find(name);
  return found == json.end() ? none : *found;
}

/// Reads each element of a list by `read`, which returns whether it is right.
template <typename Read>
Result<void> each(const Json& json, const char* list, Read read) {
  const Json& elements = member(json, list);
  if (!elements.is_array()) return wrong(list, "expected a list");
  if (elements.size() > mostElements)
    return wrong(list, "has more than " + std::to_string(mostElements) + " elements");
  for (const Json& element : elements)
    if (!read(element)) return wrong(list, "has an element that is wrong");
  return {};
}

Result<void> readSubscriptions(const Json& json, FoxgloveRequest& request) {
  return each(json, "subscriptions", [&](const Json& element) {
    const auto id = number(member(element, "id")), channel = number(member(element, "channelId"));
    if (id && channel) request.subscriptions.push_back({*id, *channel});
    return id && channel;
  });
}

Result<void> readIds(const Json& json, FoxgloveRequest& request) {
  return each(json, "subscriptionIds", [&](const Json& element) {
    const auto id = number(element);
    if (id) request.ids.push_back(*id);
    return id.has_value();
  });
}

Result<void> readNames(const Json& json, FoxgloveRequest& request) {
  return each(json, "parameterNames", [&](const Json& element) {
    if (element.is_string()) request.names.push_back(element.get<std::string>());
    return element.is_string();
  });
}

Result<void> readParameters(const Json& json, FoxgloveRequest& request) {
  return each(json, "parameters", [&](const Json& element) {
    const Json& name = member(element, "name");
    if (!name.is_string()) return false;
    request.parameters.push_back({name.get<std::string>(), member(element, "value")});
    request.names.push_back(request.parameters.back().name);
    return true;
  });
}

Result<void> readLists(const Json& json, FoxgloveRequest& request) {
  switch (request.kind) {
    case Kind::subscribe:
      return readSubscriptions(json, request);
    case Kind::unsubscribe:
      return readIds(json, request);
    case Kind::setParameters:
      return readParameters(json, request);
    default:
      return readNames(json, request);
  }
}

/// A word of a configuration file as JSON.
Json wordJson(const Word& word) {
  const std::string& text = word.text;
  if (word.quoted) return text;
  if (text == "true" || text == "false") return text == "true";
  if (const auto whole = numberFrom<std::int64_t>(text)) return *whole;
  const auto real = numberFrom<double>(text);
  if (real && std::isfinite(*real)) return *real;
  return text;
}

Result<std::string> wordText(const Json& value) {
  if (value.is_boolean()) return std::string{value.get<bool>() ? "true" : "false"};
  if (value.is_number_unsigned()) return numberText(value.get<std::uint64_t>());
  if (value.is_number_integer()) return numberText(value.get<std::int64_t>());
  if (value.is_number()) return numberText(value.get<double>());
  if (value.is_string()) return quotedWord(value.get_ref<const std::string&>());
  return wrong("value", "expected a number, a truth value, a text or a list of these");
}

}  // namespace

Result<FoxgloveRequest> parseFoxgloveRequest(std::string_view text) {
  const auto json = parseJson(text, "client");
  if (!json) return json.error();
  const Json& op = member(*json, "op");
  if (!op.is_string()) return wrong("op", "expected the name of an operation");
  for (const auto& [name, kind] : operations) {
    if (op.get_ref<const std::string&>() != name) continue;
    FoxgloveRequest request{.kind = kind};
    if (const Json& id = member(*json, "id"); id.is_string()) request.id = id.get<std::string>();
    if (auto done = readLists(*json, request); !done) return done.error();
    return request;
  }
  return wrong("op", "'" + op.get<std::string>() + "' is not supported");
}

Json parameterJson(const std::string& name, const std::string& words) {
  const auto isNumber = [](const Json& value) { return value.is_number(); };
  Json json{{"name", name}};
  const auto parts = wordsOf(words);
  if (!parts) {
    json["value"] = words;  // of a robot elsewhere that writes otherwise
  } else if (parts->size() == 1) {
    json["value"] = wordJson(parts->front());
    if (isNumber(json["value"])) json["type"] = "float64";
  } else {
    Json list = Json::array();
    for (const Word& word : *parts) list.push_back(wordJson(word));
    const bool areNumbers = !list.empty() && std::ranges::all_of(list, isNumber);
    json["value"] = std::move(list);
    if (areNumbers) json["type"] = "float64_array";
  }
  return json;
}

Result<std::string> parameterText(const Json& value) {
  if (!value.is_array()) return wordText(value);
  std::string text;
  for (const Json& element : value) {
    const auto word = wordText(element);
    if (!word) return word.error();
    text += (text.empty() ? "" : " ") + *word;
  }
  return text;
}

}  // namespace gt
