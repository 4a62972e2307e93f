#pragma once
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "measure/Job.h"

namespace gt {

/// A parameter of an experiment.
struct Parameter {
  enum class Kind {
    each,    ///< One of the values; each value is a separate job.
    choice,  ///< One of the values, by default the first.
    number,  ///< By default the value.
    text     ///< By default the value; a single word.
  };
  std::string name, description;
  Kind kind;
  std::vector<std::string> values;
  /// Whether the figures' names contain the value after their group, unless it is the first value:
  /// match.benign.goals.
  bool inNames = false;
};

/// A measurement that depends on a seed. The first word of its name is the group of its figures.
struct Experiment {
  std::string name, description;
  std::vector<Parameter> parameters;
  /// Executes a job that has all parameters. The result must only depend on job and data: the same
  /// job yields the same values on all machines and in parallel with all other jobs.
  Result<Measurement> (*measure)(const Job& job, const DataRoot& root);
  bool once = false;   ///< Measured on the first seed only.
  bool alone = false;  ///< No other job may run beside it in the same program.
};
using Experiments = std::vector<Experiment>;

/// Selects experiments and parameters to be measured.
struct JobSelection {
  std::vector<std::uint64_t> seeds;
  std::vector<std::string> only;  ///< Experiments or groups; empty: all.
  /// Values of parameters, NAME=VALUE, for those experiments that have the parameter.
  std::vector<std::string> settings;
};

/// Parses seeds: 3 or 21..30.
Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text);

/// Returns the jobs of a selection, in the order of the experiments. Names and settings that no
/// experiment has are an error.
Result<std::vector<Job>> listJobs(const Experiments& experiments, const JobSelection& selection,
                                  const std::string& commit);

/// Returns the experiment with a name; null if there is none.
const Experiment* findExperiment(const Experiments& experiments, const std::string& name);

/// Completes a job by the default values of missing parameters and by the commit. Returns an error
/// if there is no such experiment, parameter or value, or if the job requires another commit.
Result<Job> completed(Job job, const Experiments& experiments, const std::string& commit);

}  // namespace gt
