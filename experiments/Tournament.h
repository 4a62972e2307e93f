#pragma once
#include <string>
#include <vector>

#include "base/DataRoot.h"
#include "measure/Experiment.h"

namespace gt {

/// The jobs of a tournament: every two teams play each other on each seed, once in each color. All
/// play on the same seeds. Teams are as `teamFolder` takes them; the jobs name them with the
/// fingerprints of their files. The settings are those of the experiment `match`, whose profile is
/// padova if they do not say otherwise. Fewer than two teams are an error, as is one given twice.
Result<std::vector<Job>> listTournament(const std::vector<std::string>& teams,
                                        const std::vector<std::uint64_t>& seeds,
                                        std::vector<std::string> settings, const DataRoot& root);

}  // namespace gt
