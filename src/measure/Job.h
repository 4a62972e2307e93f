#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "measure/Figures.h"

namespace gt {

/// A measurement to be executed: an experiment with its parameters, on a seed, by the program built
/// from a commit. Its text is one line, which is unique for a job:
///
///     match minutes=10 seed=7 commit=9ce66a20c3f1
struct Job {
  std::string experiment;
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 1;
  std::string commit;  ///< Empty: any commit.

  std::string text() const;
  /// The parameter with a name, which must exist; jobs returned by `completed` have all parameters.
  const std::string& parameter(const std::string& name) const { return parameters.at(name); }
  bool flag(const std::string& name) const { return parameter(name) == "true"; }
  double number(const std::string& name) const;

  /// Orders jobs by experiment, parameters and seed.
  auto operator<=>(const Job&) const = default;
};

/// Parses a job from a line of text; `seed` and `commit` are optional.
Result<Job> parseJob(std::string_view line);
/// Parses a list of jobs; empty lines and lines that begin with # are skipped. Errors state the
/// line.
Result<std::vector<Job>> parseJobs(std::string_view text, const std::string& sourceName);

/// The result of a job: the raw values of one run by the names of their figures.
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

/// An executed job and its measurement. Its text is one line of JSON.
struct JobResult {
  Job job;
  Measurement measurement;

  std::string text() const;
};

Result<JobResult> parseJobResult(std::string_view line);

}  // namespace gt
