#include "robot/TeamSolutions.h"

#include <algorithm>
#include <filesystem>

namespace gt {
namespace {

bool isOfTeam(const Configuration::SolutionChoice& choice) {
  return std::filesystem::path{choice.file}.filename() == teamSolutions;
}

}  // namespace

void layOver(std::vector<Configuration::SolutionChoice>& choices,
             const std::vector<Configuration::SolutionChoice>& team) {
  std::erase_if(choices, [&](const Configuration::SolutionChoice& choice) {
    return std::ranges::find(team, choice.task, &Configuration::SolutionChoice::task) != team.end();
  });
  choices.insert(choices.end(), team.begin(), team.end());
}

bool isInherited(const Configuration::SolutionChoice& choice,
                 const std::vector<Configuration::SolutionChoice>& choices) {
  return !isOfTeam(choice) && std::ranges::any_of(choices, isOfTeam);
}

}  // namespace gt
