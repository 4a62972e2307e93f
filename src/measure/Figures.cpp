#include "measure/Figures.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/File.h"
#include "base/Statistics.h"
#include "streams/Json.h"

namespace gt {

void Figures::add(std::string name, std::string unit, const std::vector<double>& runs, Aim aim,
                  const std::vector<std::uint64_t>& seeds) {
  if (runs.empty()) return;
  assert(seeds.empty() || seeds.size() == runs.size());
  figures_.push_back({std::move(name), std::move(unit), mean(runs), runs.size(), quantile(runs, 0),
                      quantile(runs, 1), quantile(runs, 0.5), quantile(runs, 0.95), aim, runs});
  if (seeds.empty()) return;
  const auto [low, high] = std::ranges::minmax_element(runs);
  figures_.back().lowSeed = seeds[static_cast<std::size_t>(low - runs.begin())];
  figures_.back().highSeed = seeds[static_cast<std::size_t>(high - runs.begin())];
}

void Figures::addRatio(std::string name, std::string_view figure, std::string_view to, Aim aim) {
  const Figure* of = find(figure);
  const Figure* by = find(to);
  if (!of || !by) return;
  figures_.push_back({std::move(name),
                      "times",
                      of->value / by->value,
                      of->n,
                      of->low / by->high,
                      of->high / by->low,
                      of->median / by->median,
                      of->p95 / by->p95,
                      aim,
                      {}});
}

const Figure* Figures::find(std::string_view name) const {
  const auto found = std::ranges::find(figures_, name, &Figure::name);
  return found == figures_.end() ? nullptr : &*found;
}

void Figures::print() const {
  const auto seedOf = [](const std::optional<std::uint64_t>& seed) {
    return seed ? fmt::format("({})", *seed) : "";
  };
  fmt::print("{:<52} {:>9} {:<9} {:>4} {:>9} {:<6} {:>9} {:<6}  {}\n", "figure", "value", "unit",
             "n", "low", "(seed)", "high", "(seed)", "aim");
  std::map<std::string, int> grids;
  for (const Figure& f : figures_) {
    if (const auto at = f.name.find(".at."); at != f.name.npos) {
      ++grids[f.name.substr(0, at)];
      continue;
    }
    std::string aim;
    if (f.aim.kind != Aim::Kind::none)
      aim = fmt::format("{} {:g}  {}", f.aim.kind == Aim::Kind::atMost ? "<=" : ">=", f.aim.value,
                        f.aim.met(f.value) ? "met" : "MISSED");
    fmt::print("{:<52} {:>9.1f} {:<9} {:>4} {:>9.1f} {:<6} {:>9.1f} {:<6}  {}\n", f.name, f.value,
               f.unit, f.n, f.low, seedOf(f.lowSeed), f.high, seedOf(f.highSeed), aim);
  }
  for (const auto& [name, count] : grids)
    fmt::print("{}.at.*: {} figures of single places, which the file holds\n", name, count);
}

std::string Figures::json() const {
  auto list = Json::array();
  for (const Figure& f : figures_) {
    Json object{{"name", f.name}, {"value", f.value}, {"unit", f.unit},     {"n", f.n},
                {"low", f.low},   {"high", f.high},   {"median", f.median}, {"p95", f.p95}};
    if (f.aim.kind != Aim::Kind::none) {
      object["aim"] = f.aim.value;
      object["met"] = f.aim.met(f.value);
    }
    if (f.lowSeed) object["lowSeed"] = *f.lowSeed;
    if (f.highSeed) object["highSeed"] = *f.highSeed;
    if (!f.runs.empty()) object["runs"] = f.runs;
    list.push_back(std::move(object));
  }
  return list.dump(1) + '\n';
}

Result<void> Figures::write(const std::string& path) const {
  std::error_code ignored;  // then writing reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{path}.parent_path(), ignored);
  return writeFile(path, json());
}

}  // namespace gt
