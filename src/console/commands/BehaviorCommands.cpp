#include <algorithm>
#include <filesystem>

#include "base/File.h"
#include "base/Suggestion.h"
#include "console/Commands.h"
#include "representations/behavior/BehaviorRequest.h"
#include "robot/Configuration.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// The report's name of the behavior that plays soccer.
constexpr std::string_view reportBehavior = "gt03";

/// The agents files of the root's folder behavior/, without extension.
std::vector<std::string> behaviorNames(Console& console) {
  std::vector<std::string> names;
  std::error_code failed;
  for (const auto& entry :
       fs::directory_iterator{console.session().options().root.path("behavior"), failed}) {
    const auto text = entry.path().extension() == ".xabsl" ? readFile(entry.path().string())
                                                           : Result<std::string>{Error{}};
    if (text && (text->starts_with("agent ") || text->find("\nagent ") != text->npos))
      names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

template <typename T>
std::vector<std::string> namesIn(const std::vector<T>& elements) {
  std::vector<std::string> names;
  for (const T& element : elements) names.push_back(element.name);
  std::sort(names.begin(), names.end());
  return names;
}

/// Symbols that can be shown: those without parameters.
std::vector<std::string> symbolNames(const xabsl::Model& model, bool inputs) {
  std::vector<std::string> names;
  for (const xabsl::Symbol& symbol : model.symbols)
    if ((symbol.kind == xabsl::SymbolKind::input) == inputs && symbol.parameters.empty())
      names.push_back(symbol.name);
  std::sort(names.begin(), names.end());
  return names;
}

/// Name and parameters, as in go_to_point(x, y, angle).
template <typename T>
std::vector<std::string> signatures(const std::vector<T>& elements) {
  std::vector<std::string> lines;
  for (const T& element : elements) {
    std::string line = element.name;
    for (const xabsl::Parameter& p : element.parameters)
      line += " " + p.name + (p.unit.empty() ? "" : "[" + p.unit + "]");
    lines.push_back(line);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

Result<void> sendControl(Console& console,
                         const std::function<void(BehaviorControlRequest&)>& change) {
  return console.forEachRobot([&](ConsoleRobot& robot) {
    change(robot.behavior);
    return robot.observed().send(robot.behavior);
  });
}

Result<void> xlb(Console& console, const Words& words) {
  if (words[1] == "?") {
    list(console, behaviorNames(console));
    return {};
  }
  const std::string name = words[1] == reportBehavior ? "GT2003" : words[1];
  const std::string path =
      fs::is_regular_file(name) ? name : dataFile(console, name, "behavior", ".xabsl");
  const std::string before = std::exchange(console.session().behavior, path);
  console.forgetBehavior();
  if (const auto model = console.behavior(); !model) {
    console.session().behavior = before;
    return model.error();
  }
  const auto request = readBehaviorTexts(path);
  if (!request) return request.error();
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    robot.behavior = {};
    if (auto done = robot.observed().send(robot.behavior); !done) return done;
    return robot.observed().request(*request);
  });
}

/// The values of a type; empty if they are numbers.
std::vector<std::string> valuesOf(const xabsl::Model& model, xabsl::Type type) {
  if (type.kind == xabsl::ValueKind::boolean) return {"false", "true"};
  if (type.kind == xabsl::ValueKind::enumeration)
    return namesIn(model.enumerations[static_cast<std::size_t>(type.enumeration)].elements);
  return {};
}

/// The values of an output symbol.
std::vector<std::string> valuesOf(const xabsl::Model& model, const std::string& symbol) {
  for (const xabsl::Symbol& s : model.symbols)
    if (s.name == symbol) return valuesOf(model, s.type);
  return {};
}

/// A value as it was typed, if it is one of a parameter or symbol: a number or an element.
template <typename Declared>
Result<std::string> valueOf(const xabsl::Model& model, const Declared& declared,
                            const std::string& word) {
  const auto values = valuesOf(model, declared.type);
  if (values.empty()) {
    const auto number = numberOf(word);
    return number ? Result<std::string>{word} : number.error();
  }
  if (const std::string* value = findName(values, word)) return *value;
  return Error{.field = word, .what = "is no value of " + declared.name + suggestion(word, values)};
}

/// xbb and xo: the basic behavior or option that is executed instead of the engine's own.
template <typename T>
Result<void> selectRoot(Console& console, const xabsl::Model& model, const Words& words,
                        const std::vector<T>& elements, bool basicBehavior) {
  if (words[1] == "?") {
    list(console, signatures(elements));
    return {};
  }
  if (words[1] == "unchanged") {
    if (words.size() != 2) return wrongArguments(words);
    return sendControl(console, [](BehaviorControlRequest& control) {
      control.root.clear();
      control.parameters.clear();
    });
  }
  const auto names = namesIn(elements);
  const std::string* name = findName(names, words[1]);
  if (!name)
    return Error{.field = words[1],
                 .what = "the behavior has none of this name; try " + words[0] + " ?"};
  const auto& declared =
      std::ranges::find_if(elements, [&](const T& e) { return e.name == *name; })->parameters;
  if (words.size() - 2 > declared.size())
    return Error{.field = *name, .what = "has " + std::to_string(declared.size()) + " parameters"};
  std::vector<std::string> parameters;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const auto value = valueOf(model, declared[i - 2], words[i]);
    if (!value) return value.error();
    parameters.push_back(*value);
  }
  return sendControl(console, [&](BehaviorControlRequest& control) {
    control.root = *name;
    control.basicBehavior = basicBehavior;
    control.parameters = parameters;
  });
}

Result<void> xbb(Console& console, const Words& words) {
  const auto model = console.behavior();
  return model ? selectRoot(console, **model, words, (*model)->behaviors, true) : model.error();
}

Result<void> xo(Console& console, const Words& words) {
  const auto model = console.behavior();
  return model ? selectRoot(console, **model, words, (*model)->options, false) : model.error();
}

Result<void> show(Console& console, const std::string& symbol, bool on) {
  return sendControl(console, [&](BehaviorControlRequest& control) {
    std::erase(control.shown, symbol);
    if (on) control.shown.push_back(symbol);
  });
}

Result<void> xis(Console& console, const Words& words) {
  const auto model = console.behavior();
  if (!model) return model.error();
  const auto names = symbolNames(**model, true);
  if (words[1] == "?") {
    list(console, names);
    return {};
  }
  const std::string* name = findName(names, words[1]);
  if (!name) return Error{.field = words[1], .what = "there is no such input symbol; try xis ?"};
  return show(console, *name, words[2] == "on");
}

Result<void> xos(Console& console, const Words& words) {
  const auto model = console.behavior();
  if (!model) return model.error();
  const auto names = symbolNames(**model, false);
  if (words[1] == "?") {
    list(console, names);
    return {};
  }
  const std::string* found = findName(names, words[1]);
  if (!found) return Error{.field = words[1], .what = "there is no such output symbol; try xos ?"};
  const std::string symbol = *found, &word = words[2];
  const auto values = valuesOf(**model, symbol);
  if (word == "?") {
    list(console, values);
    return {};
  }
  // An element may be called on or off, too, as those of LEDs are: led.top.on is the value.
  if (word == "on" || word == "off") return show(console, symbol, word == "on");
  const auto set = [&](const std::optional<std::string>& value) {
    return sendControl(console, [&](BehaviorControlRequest& control) {
      std::erase_if(control.outputs, [&](const auto& output) { return output.symbol == symbol; });
      if (value) control.outputs.push_back({symbol, *value});
    });
  };
  if (word == "unchanged") return set(std::nullopt);
  const auto& declared =
      *std::ranges::find_if((*model)->symbols, [&](const auto& s) { return s.name == symbol; });
  // The report writes an element behind the symbol's name: head-control-mode.search-for-ball.
  const bool prefixed = word.starts_with(words[1] + ".");
  const auto value = valueOf(**model, declared, prefixed ? word.substr(words[1].size() + 1) : word);
  return value ? set(*value) : value.error();
}

enum class Names { behaviors, options, inputs, outputs };

template <Names names>
std::vector<std::string> choices(Console& console, const Words& before) {
  const auto model = console.behavior();
  if (!model) return {};
  std::vector<std::string> list;
  if (before.size() == 1) {
    list = names == Names::behaviors ? namesIn((*model)->behaviors)
           : names == Names::options ? namesIn((*model)->options)
                                     : symbolNames(**model, names == Names::inputs);
    list.emplace_back("?");
    if (names == Names::behaviors || names == Names::options) list.emplace_back("unchanged");
  } else if (before.size() == 2 && names == Names::inputs) {
    list = {"on", "off"};
  } else if (before.size() == 2 && names == Names::outputs) {
    list = valuesOf(**model, before[1]);
    for (const char* word : {"on", "off", "?", "unchanged"}) list.emplace_back(word);
  }
  return list;
}

std::vector<std::string> behaviorChoices(Console& console, const Words&) {
  auto names = behaviorNames(console);
  names.emplace_back("?");
  return names;
}

}  // namespace

const std::string* findName(const std::vector<std::string>& names, std::string_view word) {
  std::string spelled{word};
  const auto find = [&] { return std::ranges::find(names, spelled); };
  auto found = find();
  if (found == names.end()) {
    std::replace(spelled.begin(), spelled.end(), '-', '_');
    found = find();
  }
  return found == names.end() ? nullptr : &*found;
}

std::vector<Command> behaviorCommands() {
  constexpr auto kind = Command::Kind::robot;
  return {
      {kind, "behavior", "? | NAME", "The same as xlb.", xlb, behaviorChoices, true},
      {kind, "xbb", "? | unchanged | BEHAVIOR {VALUE}",
       "Has a basic behavior executed instead of what the engine selects; its parameters may "
       "follow.",
       xbb, choices<Names::behaviors>, true},
      {kind, "xis", "? | INPUTSYMBOL (on | off)",
       "Shows an input symbol in the Xabsl2 view, or not.", xis, choices<Names::inputs>, true},
      {kind, "xlb", "? | NAME",
       "Loads a behavior, one of behavior/ or a file, and switches the robots to it. Without it "
       "the commands for Xabsl2 accept the names of the behavior that the robots began with.",
       xlb, behaviorChoices, true},
      {kind, "xo", "? | unchanged | OPTION {VALUE}",
       "Has an option executed instead of the engine's root option; its parameters may follow.", xo,
       choices<Names::options>, true},
      {kind, "xos", "? | OUTPUTSYMBOL (on | off | ? | unchanged | VALUE)",
       "Shows an output symbol in the Xabsl2 view, or not; sets it to a value that lasts; prints "
       "its "
       "values; or leaves it to the engine.",
       xos, choices<Names::outputs>, true}};
}

}  // namespace gt
