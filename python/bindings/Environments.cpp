#include "Environments.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <numeric>

#include "Failure.h"
#include "Root.h"
#include "base/Enum.h"
#include "base/Suggestion.h"
#include "environments/Environments.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

/// Environments as Python has them: one call at a time, without the interpreter's lock.
class Worlds {
 private:
  std::size_t checked(std::size_t world) const {
    if (world < worlds_->count()) return world;
    throw Failure{Error{.field = "world", .what = "there are not so many"}};
  }

  /// Runs something without the interpreter's lock, if nothing else runs.
  template <typename Run>
  auto alone(const Run& run) {
    struct Release {
      std::atomic_flag& busy;
      ~Release() { busy.clear(); }
    };
    if (busy_.test_and_set())
      throw Failure{Error{.field = "environment", .what = "runs in another thread"}};
    const Release release{busy_};
    const nb::gil_scoped_release others;
    return run();
  }

 public:
  using Bounds = std::vector<std::tuple<std::string, double, double>>;
  using Actions = nb::ndarray<const float, nb::c_contig, nb::device::cpu>;

  Worlds(const std::string& environment, const std::string& observations,
         const std::string& actions, const std::string& agents, const std::string& fidelity,
         const std::string& profile, double seconds, const Bounds& randomize, std::size_t count,
         std::size_t threads, const std::string& root) {
    EnvironmentOptions options{.environment = environment,
                               .observations = observations,
                               .actions = actions,
                               .agents = agents,
                               .fidelity = fidelity,
                               .randomize = {}};
    const auto known = enumValue<Profile>(profile);
    if (!known)
      throw Failure{Error{
          .field = "profile",
          .what = "there is no '" + profile + "'" +
                  suggestion(profile, {enumNames<Profile>.begin(), enumNames<Profile>.end()})}};
    options.profile = *known;
    options.seconds = seconds;
    for (const auto& [name, low, high] : randomize) options.randomize.push_back({name, low, high});
    worlds_ = orThrow(Environments::make(options, findRoot(root), count, threads));
  }

  const Environment& first() const { return worlds_->first(); }
  Environments& all() { return *worlds_; }

  void reset(std::optional<std::uint64_t> seed) {
    orThrow(alone([&] { return worlds_->resetAll(seed); }));
  }
  void resetOne(std::size_t world, std::optional<std::uint64_t> seed) {
    orThrow(alone([&] { return worlds_->reset(checked(world), seed); }));
  }
  void step(const Actions& actions, bool autoreset) {
    const std::span<const float> numbers{actions.data(), actions.size()};
    orThrow(alone([&] { return worlds_->step(numbers, autoreset); }));
  }
  std::string save(std::size_t world) {
    return alone([&] { return worlds_->save(checked(world)); });
  }
  void load(std::size_t world, const std::string& text) {
    orThrow(alone([&] { return worlds_->load(checked(world), text); }));
  }
  nb::object picture(std::size_t world) {
    auto image =
        std::make_unique<RgbImage>(alone([&] { return worlds_->picture(checked(world)); }));
    const std::size_t shape[] = {static_cast<std::size_t>(image->height),
                                 static_cast<std::size_t>(image->width), 3};
    std::uint8_t* const pixels = image->pixels.data();
    const nb::capsule owner(image.release(),
                            [](void* p) noexcept { delete static_cast<RgbImage*>(p); });
    return nb::ndarray<nb::numpy, std::uint8_t>(pixels, 3, shape, owner).cast();
  }

 private:
  std::unique_ptr<Environments> worlds_;
  std::atomic_flag busy_;
};

/// A view of numbers that belong to the environments: (worlds, ...).
template <typename N, typename Numbers>
nb::object viewOf(const nb::object& self, Numbers numbers, std::vector<std::size_t> shape) {
  return nb::ndarray<nb::numpy, N>(reinterpret_cast<N*>(numbers.data()), shape.size(), shape.data(),
                                   self)
      .cast();
}

nb::object observationsOf(const nb::object& self) {
  auto& worlds = nb::cast<Worlds&>(self);
  const Space& space = worlds.first().observationSpace();
  std::vector<std::size_t> shape{worlds.all().count(), worlds.all().agents()};
  if (!space.isImage()) {
    shape.push_back(space.count());
    return viewOf<float>(self, worlds.all().observations(), shape);
  }
  shape.insert(shape.end(), {space.height, space.width, 3});
  return viewOf<std::uint8_t>(self, worlds.all().observations(), shape);
}

nb::list componentsOf(const Space& space) {
  nb::list list;
  for (const Component& c : space.components)
    list.append(nb::make_tuple(c.name, c.unit, c.low, c.high, c.what));
  return list;
}

template <typename E>
nb::list namesOf(const std::vector<E>& list) {
  nb::list names;
  for (const E e : list) names.append(std::string{enumName(e)});
  return names;
}

nb::list descriptions() {
  nb::list list;
  for (const EnvironmentDescription& d : environments()) {
    nb::dict one;
    one["name"] = std::string{d.name};
    one["summary"] = std::string{d.summary};
    one["observations"] = namesOf(d.observations);
    one["actions"] = namesOf(d.actions);
    one["agents"] = namesOf(d.agents);
    one["fidelities"] = namesOf(d.fidelities);
    one["seconds"] = d.seconds;
    one["end"] = std::string{d.end};
    list.append(one);
  }
  return list;
}

}  // namespace

void bindEnvironments(nb::module_& module) {
  module.def("environments", &descriptions,
             nb::sig("def environments() -> list[dict[str, typing.Any]]"),
             "What is to be known about each environment: its name, a summary, the kinds of\n"
             "observations, actions, agents and the fidelities that it offers (the first are its\n"
             "defaults), after how many seconds episodes are truncated, and what terminates one.");
  nb::class_<Worlds>(module, "Environments",
                     "Worlds of one kind that are stepped together; see gt2003.envs.")
      .def(nb::init<const std::string&, const std::string&, const std::string&, const std::string&,
                    const std::string&, const std::string&, double, const Worlds::Bounds&,
                    std::size_t, std::size_t, const std::string&>(),
           "environment"_a, nb::kw_only(), "observations"_a, "actions"_a, "agents"_a, "fidelity"_a,
           "profile"_a, "seconds"_a, "randomize"_a, "count"_a, "threads"_a, "root"_a)
      .def("reset", &Worlds::reset, "seed"_a.none(), "All worlds, with seeds from this one on.")
      .def("reset_one", &Worlds::resetOne, "world"_a, "seed"_a.none())
      .def("step", &Worlds::step, "actions"_a, "autoreset"_a,
           nb::sig("def step(self, actions: numpy.typing.NDArray[numpy.float32], autoreset: bool) "
                   "-> None"))
      .def("save", &Worlds::save, "world"_a)
      .def("load", &Worlds::load, "world"_a, "state"_a)
      .def("picture", &Worlds::picture, "world"_a,
           nb::sig("def picture(self, world: int) -> numpy.typing.NDArray[numpy.uint8]"))
      .def_prop_ro("agents", [](Worlds& w) { return w.first().agents(); })
      .def_prop_ro("seconds_per_step", [](Worlds& w) { return w.first().secondsPerStep(); })
      .def_prop_ro(
          "terms",
          [](Worlds& w) {
            nb::list list;
            for (const RewardTerm& term : w.first().terms())
              list.append(nb::make_tuple(term.name, term.what));
            return list;
          },
          nb::sig("def terms(self) -> list[tuple[str, str]]"),
          "What rewards are the sum of: names and what they are.")
      .def_prop_ro(
          "action_components", [](Worlds& w) { return componentsOf(w.first().actionSpace()); },
          nb::sig("def action_components(self) -> list[tuple[str, str, float, float, str]]"),
          "Name, unit, lowest and highest value, and a sentence.")
      .def_prop_ro(
          "observation_components",
          [](Worlds& w) { return componentsOf(w.first().observationSpace()); },
          nb::sig("def observation_components(self) -> list[tuple[str, str, float, float, str]]"))
      .def_prop_ro("observations", &observationsOf,
                   nb::sig("def observations(self) -> numpy.typing.NDArray[typing.Any]"),
                   "Views of what the last step or reset left: (worlds, agents, ...).")
      .def_prop_ro(
          "rewards",
          [](const nb::object& self) {
            Environments& all = nb::cast<Worlds&>(self).all();
            return viewOf<double>(self, all.rewards(), {all.count(), all.agents()});
          },
          nb::sig("def rewards(self) -> numpy.typing.NDArray[numpy.float64]"))
      .def_prop_ro(
          "term_values",
          [](const nb::object& self) {
            Environments& all = nb::cast<Worlds&>(self).all();
            return viewOf<double>(self, all.terms(),
                                  {all.count(), all.agents(), all.first().terms().size()});
          },
          nb::sig("def term_values(self) -> numpy.typing.NDArray[numpy.float64]"))
      .def_prop_ro(
          "terminated",
          [](const nb::object& self) {
            Environments& all = nb::cast<Worlds&>(self).all();
            return viewOf<bool>(self, all.terminated(), {all.count()});
          },
          nb::sig("def terminated(self) -> numpy.typing.NDArray[numpy.bool_]"))
      .def_prop_ro(
          "truncated",
          [](const nb::object& self) {
            Environments& all = nb::cast<Worlds&>(self).all();
            return viewOf<bool>(self, all.truncated(), {all.count()});
          },
          nb::sig("def truncated(self) -> numpy.typing.NDArray[numpy.bool_]"));
}

}  // namespace gt::python
