#include "console/Console.h"

#include "Fuzz.h"
#include "console/Condition.h"

namespace {

class NoScreen : public gt::Screen {
 public:
  void print(std::string_view) override {}
};

/// Whether a line may be executed here: what names files would read or write any of the machine,
/// sounds are this machine's, what lets time pass or plays many games would take long, and sockets
/// are another target's.
bool mayBeExecuted(std::string_view line) {
  static constexpr std::string_view elsewhere[] = {
      "call",   "layout",   "behavior", "xlb",     "sl",    "sc",     "log",   "save", "load",
      "run",    "until",    "test",     "picture", "plot",  "film",   "scene", "seed", "reset",
      "rewind", "joystick", "st",       "mof",     "sound", "config", "deploy"};
  const std::size_t begin = std::min(line.find_first_not_of(" \t\r\""), line.size());
  for (const std::string_view name : elsewhere)
    if (line.substr(begin).starts_with(name)) return false;
  return line.find('\\') == line.npos;
}

}  // namespace

/// Lines of a console or a script, one after another on the same small simulation, each completed
/// and read as a condition, too.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static NoScreen screen;
  static const auto session = [] {
    gt::MatchOptions options;
    options.scene = "scenes/one-robot.scene";
    auto made = gt::Session::make(options, screen);
    if (!made) std::abort();
    (*made)->simulation().takeImages(false);
    return std::move(*made);
  }();
  static gt::Console console{*session};
  const std::string text{gt::textOf(data, size)};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (mayBeExecuted(line)) {
      (void)!console.execute(line);
      if (size % 16 == 0 && line.find('/') == line.npos) (void)console.completions(line);
    }
    if (const auto condition = gt::Condition::parse(line)) (void)!condition->holds(console);
    at = end + 1;
  }
  if (size % 4 == 0) session->step();  // most of the time, if always
  for (const auto& robot : session->robots()) robot->observed().update();
  return 0;
}
