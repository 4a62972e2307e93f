#include "measure/Figures.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/Statistics.h"
#include "streams/File.h"
#include "streams/Json.h"

namespace gt {

void Figures::add(std::string name, std::string unit, const std::vector<double>& runs, Aim aim) {
  if (runs.empty()) return;
  figures_.push_back({std::move(name), std::move(unit), mean(runs), runs.size(), quantile(runs, 0),
                      quantile(runs, 1), quantile(runs, 0.5), quantile(runs, 0.95), aim, runs});
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
  fmt::print("{:<52} {:>9} {:<9} {:>4} {:>9} {:>9}  {}\n", "figure", "value", "unit", "n", "low",
             "high", "aim");
  for (const Figure& f : figures_) {
    std::string aim;
    if (f.aim.kind != Aim::Kind::none)
      aim = fmt::format("{} {:g}  {}", f.aim.kind == Aim::Kind::atMost ? "<=" : ">=", f.aim.value,
                        f.aim.met(f.value) ? "met" : "MISSED");
    fmt::print("{:<52} {:>9.1f} {:<9} {:>4} {:>9.1f} {:>9.1f}  {}\n", f.name, f.value, f.unit, f.n,
               f.low, f.high, aim);
  }
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
