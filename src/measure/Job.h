#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// A measurement to be done: an experiment with its parameters, on a seed, by the program built
/// from a commit. As text it is one line, the same for the same job:
///
///     match minutes=10 seed=7 commit=9ce66a20c3f1
struct Job {
  std::string experiment;
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 1;
  std::string commit;  ///< Empty: of any commit.

  std::string text() const;
  /// The parameter of that name, which the job must have; jobs of `completed` have all.
  const std::string& parameter(const std::string& name) const { return parameters.at(name); }
  bool flag(const std::string& name) const { return parameter(name) == "true"; }
  double number(const std::string& name) const;

  /// By experiment, parameters and seed.
  auto operator<=>(const Job&) const = default;
};

/// Reads a job from a line of text; `seed` and `commit` may be missing.
Result<Job> parseJob(std::string_view line);
/// Reads a list of jobs; empty lines and lines that begin with # are passed over. Errors name the
/// line.
Result<std::vector<Job>> parseJobs(std::string_view text, const std::string& sourceName);

/// What a job measured: the raw values of one run by the names of their figures.
struct Measurement {
  struct Value {
    std::string name, unit;
    double value = 0;
    Aim aim;

    bool operator==(const Value&) const = default;
    static constexpr auto fields() {
      return Fields{field<&Value::name>(), field<&Value::unit>(), field<&Value::value>(),
                    field<&Value::aim>()};
    }
  };

  void add(std::string name, std::string unit, double value, Aim aim = {}) {
    values.push_back({std::move(name), std::move(unit), value, aim});
  }
  std::vector<Value> values;

  bool operator==(const Measurement&) const = default;
};
static_assert(complete<Measurement::Value>);

/// A job that was done, and what it measured. As text it is one line of JSON.
struct JobResult {
  Job job;
  Measurement measurement;

  std::string text() const;
};

Result<JobResult> parseJobResult(std::string_view line);

}  // namespace gt
