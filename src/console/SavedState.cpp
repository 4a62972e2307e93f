#include "console/SavedState.h"

#include <charconv>
#include <filesystem>

#include "streams/File.h"
#include "streams/Json.h"

namespace gt {
namespace {

/// The file's content.
struct SavedDeed {
  Time time;
  std::vector<std::string> selected;
  std::string line;

  static constexpr auto fields() {
    return std::tuple{field("time", &SavedDeed::time, "ms"),
                      field("selected", &SavedDeed::selected, "", "robots; all if empty"),
                      field("line", &SavedDeed::line)};
  }
};

struct SavedState {
  std::string scene, behavior, motions, layout;
  std::uint64_t seed = 0;
  double minutes = 0;
  Time time;
  std::string fingerprint;
  std::vector<SavedDeed> deeds;

  static constexpr auto fields() {
    using S = SavedState;
    return std::tuple{field("scene", &S::scene),
                      field("behavior", &S::behavior),
                      field("motions", &S::motions),
                      field("layout", &S::layout, "", "of all robots; empty: as the scene says"),
                      field("seed", &S::seed),
                      field("minutes", &S::minutes, "", "that the game takes", {0.001, 1e6}),
                      field("time", &S::time, "ms", "when it was saved", {0, 1e9}),
                      field("fingerprint", &S::fingerprint, "", "of the state then"),
                      field("deeds", &S::deeds, "", "commands that changed something")};
  }
};

constexpr std::size_t mostDeeds = 1'000'000;

/// FNV-1a over the bytes of numbers.
class Fingerprint {
 public:
  void add(std::span<const std::byte> bytes) {
    for (const std::byte b : bytes)
      hash_ = (hash_ ^ static_cast<std::uint64_t>(b)) * 1099511628211u;
  }
  template <typename T>
  requires std::is_arithmetic_v<T>
  void add(T number) { add(std::as_bytes(std::span{&number, 1})); }
  void add(const Vector2d& v) {
    add(v.x());
    add(v.y());
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037u;
};

void add(Fingerprint& print, const RobotBody& body) {
  print.add(body.pose.translation);
  for (const double number : {body.pose.rotation, body.height, body.tilt, body.roll, body.walked})
    print.add(number);
  for (const double angle : body.joints) print.add(angle);
}

/// What the tasks of a robot's processes provide, as bytes.
void add(Fingerprint& print, const Robot& robot) {
  std::vector<std::byte> bytes;
  for (const auto& process : robot.processes())
    for (const Plan::Process& plan : robot.plan().processes) {
      if (plan.layout.name != process->name()) continue;
      for (const Plan::Step& step : plan.order)
        for (const RepresentationType* type : step.task->outputs) {
          if (!type->encodedSize) continue;
          const void* value = process->blackboard().get(*type);
          bytes.resize(type->encodedSize(value));
          type->encodeTo(value, bytes.data());
          print.add(bytes);
        }
    }
}

std::string hexadecimal(std::uint64_t number) {
  char text[17];
  return {text, std::to_chars(text, text + sizeof text, number, 16).ptr};
}

}  // namespace

std::uint64_t fingerprint(Session& session) {
  Fingerprint print;
  const World& world = session.simulation().world();
  const Referee& referee = session.simulation().referee();
  print.add(session.time().ms);
  for (std::size_t i = 0; i < world.robotCount(); ++i) add(print, world.robot(i));
  for (std::size_t i = 0; i < world.ballCount(); ++i) {
    print.add(world.ball(i).position);
    print.add(world.ball(i).speed);
  }
  print.add(static_cast<int>(referee.state()));
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) print.add(referee.score(team));
  for (SimulatedRobot* robot : session.match().robots()) add(print, robot->robot());
  return print.value();
}

Result<void> saveState(Session& session, const std::string& file) {
  for (const auto& robot : session.robots())
    if (!robot->index())
      return Error{file, 0, robot->name(), "is no robot of the scene, so it cannot be saved"};
  if (!session.options().remote.empty())
    return Error{file, 0, "remote", "robots whose processes run elsewhere cannot be saved"};
  const MatchOptions& options = session.options();
  SavedState state{options.scene,
                   options.behavior,
                   options.motions,
                   options.layout,
                   options.seed,
                   options.minutes,
                   session.time(),
                   hexadecimal(fingerprint(session)),
                   {}};
  for (const Session::Deed& deed : session.deeds())
    state.deeds.push_back({deed.time, deed.selected, deed.line});
  std::error_code ignored;  // then writing tells what is wrong
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), ignored);
  return writeFile(file, toJson(state).dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Result<void> repeat(Console& console, const std::vector<Session::Deed>& deeds) {
  const auto selection = console.selection();
  for (const Session::Deed& deed : deeds) {
    while (console.session().time() < deed.time && console.session().step()) {
    }
    console.select(deed.selected);
    const Command* command = Console::find(deed.line.substr(0, deed.line.find(' ')));
    if (!command || !command->changes)
      return Error{"", 0, deed.line, "is no command that changes something"};
    if (auto done = console.execute(deed.line); !done) return done;
  }
  console.select(selection);
  return {};
}

Result<void> loadState(Console& console, const std::string& file) {
  const auto text = readFile(file);
  if (!text) return text.error();
  const auto json = parseJson(*text, file);
  if (!json) return json.error();
  SavedState state;
  if (const auto read = fromJson(*json, state); !read)
    return Error{file, 0, read.error().field, read.error().what};
  if (state.deeds.size() > mostDeeds) return Error{file, 0, "deeds", "are too many"};
  MatchOptions options = console.session().options();
  options.scene = state.scene;
  options.behavior = state.behavior;
  options.motions = state.motions;
  options.layout = state.layout;
  options.seed = state.seed;
  options.minutes = state.minutes;
  Session& session = console.session();
  if (auto done = session.restart(options); !done) return done;
  console.forgetBehavior();
  console.series().clear();
  std::vector<Session::Deed> deeds;
  for (const SavedDeed& deed : state.deeds) {
    if (deed.time > state.time || (!deeds.empty() && deed.time < deeds.back().time))
      return Error{file, 0, "deeds", "are not in the order of time"};
    deeds.push_back({deed.time, deed.selected, deed.line});
  }
  console.select({});
  if (auto done = repeat(console, deeds); !done)
    return Error{file, 0, done.error().field, done.error().what};
  while (session.time() < state.time && session.step()) {
  }
  if (hexadecimal(fingerprint(session)) != state.fingerprint)
    return Error{file, 0, "fingerprint",
                 "this program comes to another state; the file was written by another version, or "
                 "scene, configuration or behavior have changed"};
  return {};
}

}  // namespace gt
