#pragma once
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "measure/Job.h"

namespace gt {

/// A parameter of an experiment.
struct Parameter {
  enum class Kind {
    each,    ///< One of the values; a list has a job for each.
    choice,  ///< One of the values, by default the first.
    number,  ///< By default the value.
    text     ///< By default the value; a single word.
  };
  std::string name, description;
  Kind kind;
  std::vector<std::string> values;
  /// Whether the figures' names tell the value, behind their group, unless it is the first:
  /// match.benign.goals.
  bool inNames = false;
};

/// Something that can be measured on a seed. The first word of its name is the group of its
/// figures.
struct Experiment {
  std::string name, description;
  std::vector<Parameter> parameters;
  /// Does a job that has all parameters. Must depend on job and data alone: the same job gives the
  /// same values, wherever and beside whatever it runs.
  Result<Measurement> (*measure)(const Job& job, const DataRoot& root);
  bool once = false;   ///< Measured on the first seed only.
  bool alone = false;  ///< No other job may run beside it in the same program.
};
using Experiments = std::vector<Experiment>;

/// What of the experiments is measured.
struct JobSelection {
  std::vector<std::uint64_t> seeds;
  std::vector<std::string> only;  ///< Experiments or groups; empty: all.
  /// Values of parameters, NAME=VALUE: of those experiments that have the parameter.
  std::vector<std::string> settings;
};

/// Seeds as in 3 or 21..30.
Result<std::vector<std::uint64_t>> parseSeeds(const std::string& text);

/// The jobs of a selection, in the order of the experiments. A name or setting that no experiment
/// has is an error.
Result<std::vector<Job>> listJobs(const Experiments& experiments, const JobSelection& selection,
                                  const std::string& commit);

/// Null if there is no such experiment.
const Experiment* findExperiment(const Experiments& experiments, const std::string& name);

/// A job with all parameters, those that it does not name at their defaults, and with the commit.
/// Fails if there is no such experiment, parameter or value, or if the job asks for another commit.
Result<Job> completed(Job job, const Experiments& experiments, const std::string& commit);

}  // namespace gt
