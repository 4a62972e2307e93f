#include "Match.h"

#include <mujoco/mujoco.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/unique_ptr.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <filesystem>

#include "Failure.h"
#include "PlayedMatch.h"
#include "PlayedRobot.h"
#include "Root.h"
#include "Values.h"
#include "base/Lines.h"
#include "base/Number.h"
#include "base/Suggestion.h"
#include "match/report/Report.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

/// As many as `simgt play` keeps.
constexpr int imagesOfReports = 12;

/// A scene's file: as it is named, or of the folder scenes of the root.
std::string sceneFile(const DataRoot& root, const std::string& scene) {
  const std::filesystem::path path{scene};
  if (path.has_parent_path() || path.has_extension()) return scene;
  const std::filesystem::path file = root.path("scenes/" + scene + ".scene");
  std::error_code failed;
  if (std::filesystem::exists(file, failed)) return file.string();
  std::vector<std::string> known;
  for (const auto& other : std::filesystem::directory_iterator{file.parent_path(), failed})
    if (other.path().extension() == ".scene") known.push_back(other.path().stem().string());
  std::ranges::sort(known);
  throw Failure{
      Error{.file = file.string(), .what = "there is no such file" + suggestion(scene, known)}};
}

MatchOptions optionsOf(const std::string& root, const std::string& scene, std::size_t threads,
                       const std::string& logs) {
  constexpr std::size_t mostThreads = 256;
  if (threads < 1 || threads > mostThreads)
    throw Failure{Error{.field = "threads", .what = "must be from 1 to 256"}};
  MatchOptions options{findRoot(root)};
  options.scene = sceneFile(options.root, scene);
  options.threads = threads;
  if (logs.empty()) return options;
  options.logs = logs;
  options.images = imagesOfReports;  // what is drawn in them stands in the logs
  std::error_code failed;
  std::filesystem::create_directories(logs, failed);
  if (failed) throw Failure{Error{.file = logs, .what = failed.message()}};
  return options;
}

using Solutions = std::map<std::string, std::map<std::string, nb::object>>;

void solveAll(PlayedMatch& match, const Solutions& solutions) {
  const auto& robots = match.match().robots();
  for (const auto& [name, tasks] : solutions) {
    const auto robot = std::ranges::find(robots, name, &SimulatedRobot::name);
    if (robot == robots.end())
      throw Failure{
          Error{.field = "solutions",
                .what = "there is no robot '" + name + "'" + suggestion(name, match.robotNames())}};
    for (const auto& [task, solution] : tasks)
      match.solve(static_cast<std::size_t>(robot - robots.begin()), task, solution);
  }
}

nb::list failuresOf(PlayedMatch& match) {
  const nb::object type = nb::module_::import_("gt2003._solution").attr("SolutionFailure");
  nb::list all;
  for (const SolutionFailures::Failure& failure : match.failures())
    all.append(type(match.match().robots()[failure.robot]->name(), failure.task, failure.solution,
                    failure.time.ms, failure.trace));
  return all;
}

void initialize(PlayedMatch* self, const std::string& scene, std::uint64_t seed,
                std::optional<double> minutes, const std::string& profile, std::size_t threads,
                const std::string& logs, bool labels, const nb::object& solutions,
                const std::string& red, const std::string& blue,
                const std::vector<std::string>& truth, bool check, const std::string& root) {
  MatchOptions options = optionsOf(root, scene, threads, logs);
  options.seed = seed;
  if (minutes) options.minutes = *minutes;
  options.profile = profile;
  options.red = red;
  options.blue = blue;
  options.truth = truth;
  options.check = check;
  if (minutes && !(*minutes >= 0.01 && *minutes <= 1e4))
    throw Failure{Error{.field = "minutes", .what = "must be from 0.01 to 10000"}};
  new (self) PlayedMatch{options};
  try {
    if (labels) self->keepLabels();
    if (!solutions.is_none()) solveAll(*self, nb::cast<Solutions>(solutions));
  } catch (...) {
    self->~PlayedMatch();
    throw;
  }
}

std::unique_ptr<PlayedMatch> load(const std::string& file, std::size_t threads,
                                  const std::string& logs, bool labels, const std::string& root) {
  auto match = PlayedMatch::load(file, optionsOf(root, "match", threads, logs));
  if (labels) match->keepLabels();
  return match;
}

void place(PlayedMatch& match, const std::string& name, double x, double y,
           std::optional<double> rotation) {
  std::string line = "place " + quotedWord(name) + " " + numberText(x) + " " + numberText(y);
  if (rotation) line += " " + numberText(toDegrees(*rotation));
  match.execute(line);
}

nb::dict robotsOf(const nb::object& self) {
  nb::dict robots;
  const auto& all = nb::cast<PlayedMatch&>(self).match().robots();
  for (std::size_t i = 0; i < all.size(); ++i)
    robots[all[i]->name().c_str()] = nb::cast(PlayedRobot{self, i});
  return robots;
}

/// The body that each geom belongs to, such as field or red1.
std::vector<std::string> geomBodies(PlayedMatch& match) {
  const mjModel& model = match.match().simulation().world().model();
  std::vector<std::string> names;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const int body = model.body_rootid[model.geom_bodyid[geom]];
    const char* name = mj_id2name(&model, mjOBJ_BODY, body);
    names.emplace_back(name ? name : "");
  }
  return names;
}

const BallState& ballOf(PlayedMatch& match) {
  const World& world = match.match().simulation().world();
  if (world.ballCount() == 0) throw Failure{Error{.field = "ball", .what = "the scene has none"}};
  return world.ball(0);
}

// Solutions written in Python may refer to their match: the garbage collector has to see that.

int traverseMatch(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (nb::inst_ready(self))
    for (const PythonSolution& solution : nb::inst_ptr<PlayedMatch>(self)->joined())
      if (const int done = solution.traverse(visit, arg); done != 0) return done;
  return 0;
}

int clearMatch(PyObject* self) {
  if (nb::inst_ready(self))
    for (PythonSolution& solution : nb::inst_ptr<PlayedMatch>(self)->joined()) solution.clear();
  return 0;
}

int traverseRobot(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (nb::inst_ready(self)) Py_VISIT(nb::inst_ptr<PlayedRobot>(self)->owner().ptr());
  return 0;
}

PyType_Slot matchSlots[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverseMatch)},
                            {Py_tp_clear, reinterpret_cast<void*>(&clearMatch)},
                            {0, nullptr}};
PyType_Slot robotSlots[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverseRobot)},
                            {0, nullptr}};

/// Pickle and copy would not know how.
nb::object refuseCopy(const nb::object&) {
  throw Failure{Error{.field = "Match",
                      .what = "cannot be copied or pickled; Match.save writes its state to a file, "
                              "which Match.load reads"}};
}
const nb::sig copySignature{"def __reduce__(self) -> typing.NoReturn"};

void bindRobot(nb::module_& module) {
  nb::class_<PlayedRobot>(module, "Robot", nb::type_slots(robotSlots),
                          "A robot of a match. It keeps the match alive that it belongs to.")
      .def_prop_ro("name", &PlayedRobot::name)
      .def("__reduce__", &refuseCopy, copySignature)
      .def("get", &PlayedRobot::get, "path"_a, nb::sig("def get(self, path: str) -> typing.Any"),
           "A value by its path, as it is now: a representation (`RobotPose`), a part of one\n"
           "(`RobotPose.pose.translation`), or a parameter, as TASK.PATH or TASK.SOLUTION.PATH.\n"
           "Units are those of the fields: mm, rad, ms. A copy; it does not change later.")
      .def("set", &PlayedRobot::set, "path"_a, "value"_a.none(),
           nb::sig("def set(self, path: str, value: typing.Any) -> None"),
           "Sets a parameter, or a field of a representation, which lasts until its provider\n"
           "provides it again: switch that off by `solve(task, \"disabled\")`.")
      .def_prop_ro("representations", &PlayedRobot::representations,
                   "The names of all representations that `get` accepts, sorted.")
      .def_prop_ro("solutions", &PlayedRobot::solutions,
                   "The solution of each task that the robot runs, or \"disabled\".")
      .def(
          "solve", &PlayedRobot::solve, "task"_a, "solution"_a,
          nb::sig("def solve(self, task: str, solution: str | "
                  "collections.abc.Callable[[], typing.Any]) -> typing.Any"),
          "Has a task solved by another solution: by its name (\"disabled\": by none), or by a\n"
          "class of Python, of which an object is made for this robot and returned. Its method\n"
          "`update` takes representations by the names of `gt2003.modules`, annotated with their\n"
          "classes (`ball_percept: BallPercept`), and returns what the task provides (one object,\n"
          "or a tuple in the order of `gt2003.modules`), annotated, too. An argument annotated as\n"
          "`numpy.random.Generator` is the robot's chance, `gt2003.Previous[BallModel]` a value\n"
          "of the last cycle. If `update` raises, the solution that was there before takes over.")
      .def_prop_ro("times", &PlayedRobot::times,
                   nb::sig("def times(self) -> dict[str, gt2003.representations.Stopwatch]"),
                   "How long each task's solutions have taken so far, by the machine's clock.")
      .def("parameters", &PlayedRobot::parameters, "task"_a, "solution"_a = "",
           nb::sig("def parameters(self, task: str, solution: str = '') -> "
                   "dict[str, typing.Any]"),
           "The parameters of a solution (of the one that runs, if none is named) by path.")
      .def_prop_ro("image", &PlayedRobot::image,
                   nb::sig("def image(self) -> numpy.typing.NDArray[numpy.uint8] | None"),
                   "The robot's newest camera image: (height, width, 3), uint8, YCbCr, read only;\n"
                   "None before the first one. A view without a copy: it shows another image once\n"
                   "the match runs on. Its time and camera are `get(\"Image.time\")` and\n"
                   "`get(\"Image.info\")`.")
      .def_prop_ro("labels", &PlayedRobot::labels,
                   nb::sig("def labels(self) -> tuple[numpy.typing.NDArray[numpy.uint8], "
                           "numpy.typing.NDArray[numpy.int32]] | None"),
                   "What each pixel of the newest image shows: its color class (uint8, a\n"
                   "`representations.ColorClass`) and geom (int32, -1 for the background; see\n"
                   "`Match.geom_bodies`), both (height, width). Views as `image`. None before the\n"
                   "first one. The match must have been made with `labels=True`.")
      .def_prop_ro("true_pose", &PlayedRobot::truePose,
                   nb::sig("def true_pose(self) -> gt2003.representations.Pose2D"),
                   "Where the robot truly is on the field: a Pose2D in mm and rad.");
}

}  // namespace

void bindMatch(nb::module_& module) {
  bindRobot(module);
  nb::class_<PlayedMatch>(module, "Match", nb::type_slots(matchSlots),
                          "A simulated match: a scene that runs, with robots that play.\n\n"
                          "Scene and seed determine it to the last bit, whatever the number of\n"
                          "threads. Lengths are mm, angles rad, times ms, if nothing else is said.")
      .def("__init__", &initialize, "scene"_a = "match", nb::kw_only(), "seed"_a = 1,
           "minutes"_a = nb::none(), "profile"_a = "", "threads"_a = 1, "logs"_a = "",
           "labels"_a = false, "solutions"_a = nb::none(), "red"_a = "", "blue"_a = "",
           "truth"_a = std::vector<std::string>{}, "check"_a = false, "root"_a = "",
           nb::sig("def __init__(self, scene: str = 'match', *, seed: int = 1, "
                   "minutes: float | None = None, profile: str = '', threads: int = 1, "
                   "logs: str = '', labels: bool = False, solutions: dict[str, dict[str, str | "
                   "collections.abc.Callable[[], typing.Any]]] | None = None, red: str = '', blue: "
                   "str = '', truth: collections.abc.Sequence[str] = (), check: bool = False, "
                   "root: str = '') -> None"),
           "scene: a file, or a name of the folder scenes; minutes: both halves together, instead\n"
           "of the scene's; profile: how far all is from perfect, instead of the scene's; logs: a\n"
           "folder for the robots' logs; labels: whether `Robot.labels` are kept; solutions: for\n"
           "robots by name and tasks what `Robot.solve` takes; red, blue: teams with files of "
           "their own, a folder with any\n"
           "of config, behavior and motions, or a name of the folder teams; truth: robots and\n"
           "teams that are given the truth, which solutions Oracled read; check: whether what\n"
           "always holds is checked, for `summary().broken`; root: the data root,\n"
           "instead of the package's own.")
      .def_static(
          "load", &load, "file"_a, nb::kw_only(), "threads"_a = 1, "logs"_a = "",
          "labels"_a = false, "root"_a = "",
          "A match in the state of a file that `save` or the console has written. It plays\n"
          "the match again up to there, and goes on with the same bits.")
      .def("__reduce__", &refuseCopy, copySignature)
      .def("save", &PlayedMatch::save, "file"_a,
           "Writes the match's state: scene, seed, and all that was done to it.")
      .def("step", &PlayedMatch::step, "One step of 8 ms. False if the game is over.")
      .def("run", &PlayedMatch::run, "seconds"_a = nb::none(),
           "Lets so many seconds of simulated time pass, or plays to the end. Returns whether the\n"
           "game goes on. Python's other threads run meanwhile.")
      .def("until", &PlayedMatch::until, "predicate"_a, "seconds"_a = 600.0,
           nb::sig("def until(self, predicate: collections.abc.Callable[[], bool], "
                   "seconds: float = 600.0) -> bool"),
           "Steps until `predicate()` is true, but no longer than so many seconds of simulated\n"
           "time. Returns whether it is.")
      .def("console", &PlayedMatch::console, "line"_a, nb::kw_only(), "robot"_a = "",
           "Executes a line of the console (docs/console.md) for a robot, or for all, and returns\n"
           "what it prints. Lines that would end or replace the match are refused.")
      .def("picture", &PlayedMatch::picture, "view"_a = "scene", nb::kw_only(), "robot"_a = "",
           "numbers"_a = std::vector<double>{}, "file"_a = "",
           nb::sig("def picture(self, view: str = 'scene', *, robot: str = '', numbers: "
                   "collections.abc.Sequence[float] = (), file: str = '') -> "
                   "numpy.typing.NDArray[numpy.uint8]"),
           "What a view shows now: (height, width, 3), uint8, RGB. The views are those of the\n"
           "console (`console(\"picture ?\")`): scene, robot, image, field, ...; numbers: the\n"
           "view's own, such as from where it looks; robot: whose, instead of the first one's;\n"
           "file: where it is written, too, as .png or .svg. A robot's drawings are there once\n"
           "they were asked for: `console(\"dk BallLocator/ball on\")`.")
      .def(
          "film",
          [](const nb::object& self, const std::string& file, const std::string& view,
             const std::string& robot, const std::vector<double>& numbers) {
            return nb::module_::import_("gt2003._film")
                .attr("Film")(self, file, view, robot, numbers);
          },
          "file"_a, "view"_a = "scene", nb::kw_only(), "robot"_a = "",
          "numbers"_a = std::vector<double>{},
          nb::sig("def film(self, file: str, view: str = 'scene', *, robot: str = '', numbers: "
                  "collections.abc.Sequence[float] = ()) -> gt2003._film.Film"),
          "Films a view from now on, as MP4, 25 images a simulated second, until `end()` of what\n"
          "it returns, or until the end of a `with` block. Arguments as of `picture`.")
      .def("close", &PlayedMatch::close, "Closes the logs.")
      .def("place", &place, "name"_a, "x"_a, "y"_a, "rotation"_a = nb::none(),
           "Puts a robot on the field (mm, rad), or a ball (`ball`, `ball1`), which then rests.")
      .def_prop_ro(
          "time", [](PlayedMatch& m) { return m.match().time().ms; }, "Since the start: ms.")
      .def_prop_ro("finished", [](PlayedMatch& m) { return m.match().finished(); })
      .def_prop_ro(
          "game_state",
          [](PlayedMatch& m) {
            return std::string{enumName(m.match().simulation().referee().state())};
          },
          "initial, ready, set, playing, ..., finished.")
      .def_prop_ro(
          "score",
          [](PlayedMatch& m) {
            const Referee& referee = m.match().simulation().referee();
            return std::pair{referee.score(TeamColor::red), referee.score(TeamColor::blue)};
          },
          "Goals: red, blue.")
      .def_prop_ro(
          "events", [](PlayedMatch& m) { return toPython(valueOf(m.match().summary().events)); },
          nb::sig("def events(self) -> list[gt2003.representations.MatchEvent]"),
          "What the referee has seen so far.")
      .def(
          "summary", [](PlayedMatch& m) { return toPython(valueOf(m.match().summary())); },
          nb::sig("def summary(self) -> gt2003.representations.MatchSummary"),
          "What is to be known about the match so far.")
      .def(
          "write_summary",
          [](PlayedMatch& m, const std::string& file) {
            orThrow(writeMatchJson(file, m.match().summary()));
          },
          "file"_a, "Writes the summary as JSON: the same bytes as `simgt play`'s match.json.")
      .def_prop_ro("failures", &failuresOf,
                   nb::sig("def failures(self) -> list[gt2003.SolutionFailure]"),
                   "What solutions written in Python raised, or returned wrongly, so far.")
      .def_prop_ro(
          "times", [](PlayedMatch& m) { return toPython(valueOf(m.match().times())); },
          nb::sig("def times(self) -> list[gt2003.representations.PartTime]"),
          "How long each task took so far, over all robots, and the parts of the simulator, by "
          "the\n"
          "machine's clock.")
      .def_prop_ro("robots", &robotsOf, nb::sig("def robots(self) -> dict[str, Robot]"),
                   "The robots by name, in the scene's order.")
      .def_prop_ro(
          "ball_position", [](PlayedMatch& m) { return toPython(valueOf(ballOf(m).position)); },
          nb::sig("def ball_position(self) -> numpy.typing.NDArray[numpy.float64]"),
          "Where the ball truly is: (2,), mm.")
      .def_prop_ro(
          "ball_speed", [](PlayedMatch& m) { return toPython(valueOf(ballOf(m).speed)); },
          nb::sig("def ball_speed(self) -> numpy.typing.NDArray[numpy.float64]"),
          "The ball's true speed: (2,), mm/s.")
      .def_prop_ro("geom_bodies", &geomBodies,
                   "For each geom of `Robot.labels` the name of the body that it belongs to.");
}

}  // namespace gt::python
