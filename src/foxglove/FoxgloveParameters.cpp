// What a FoxgloveServer does with the parameters of robots.
#include <algorithm>
#include <chrono>
#include <utility>

#include "foxglove/FoxgloveRequest.h"
#include "foxglove/FoxgloveServer.h"

namespace gt {
namespace {

/// How often a robot is asked for its parameters.
constexpr std::chrono::milliseconds parameterInterval{250};

}  // namespace

/// All parameters of the solutions that a robot has, by ROBOT.TASK.SOLUTION.PATH.
FoxgloveServer::Parameters FoxgloveServer::parametersOf(Robot& robot) {
  Parameters values;
  const auto processes = robot.observed->processes();
  if (!processes) return values;
  for (const ProcessDescription& process : **processes)
    for (const TaskDescription& task : process.tasks)
      for (const SolutionDescription& solution : task.solutions)
        for (const ParameterDescription& parameter : solution.parameters)
          values[robot.observed->name() + "." + task.name + "." + solution.name + "." +
                 parameter.path] = parameter.value;
  return values;
}

/// A robot's name may be its address, with dots.
FoxgloveServer::Robot* FoxgloveServer::robotOf(std::string_view parameter) {
  const auto found = std::ranges::find_if(robots_, [&](const auto& robot) {
    const std::string& name = robot->observed->name();
    return parameter.starts_with(name) && parameter.substr(name.size()).starts_with('.');
  });
  return found == robots_.end() ? nullptr : found->get();
}

void FoxgloveServer::sendParameters(ClientId client, const std::vector<std::string>& names,
                                    const std::string& answers) {
  const std::set<std::string_view> wanted{names.begin(), names.end()};
  std::set<const Robot*> robots;
  for (const std::string_view name : wanted) robots.insert(robotOf(name));
  Json list = Json::array();
  for (const auto& robot : robots_) {
    if (!names.empty() && !robots.contains(robot.get())) continue;
    for (const auto& [name, words] : parametersOf(*robot))
      if (names.empty() || wanted.contains(name)) list.push_back(parameterJson(name, words));
  }
  sendParameters(client, std::move(list), answers);
}

void FoxgloveServer::sendParameters(ClientId client, Json list, const std::string& answers) {
  Json message{{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (!answers.empty()) message["id"] = answers;
  sendJson(client, message);
}

void FoxgloveServer::setParameters(ClientId client, const FoxgloveRequest& request,
                                   const FoxgloveSubject& subject) {
  std::set<Robot*> changed;
  std::vector<Error> faults;
  for (const auto& [name, value] : request.parameters) {
    Robot* robot = robotOf(name);
    const auto text = parameterText(value);
    const auto done =
        !robot  ? Result<void>{Error{.field = name, .what = "there is no such parameter"}}
        : !text ? Result<void>{Error{.field = name, .what = text.error().what}}
                : robot->observed->set(name.substr(robot->observed->name().size() + 1), *text);
    if (!done)
      faults.push_back(done.error());
    else
      changed.insert(robot);
  }
  reportFaults(client, Severity::error, faults);
  if (!changed.empty() && subject.parameterChanged) subject.parameterChanged();
  for (Robot* robot : changed) notifyParameters(*robot);
  if (request.id.empty()) return;
  if (request.names.empty())
    sendParameters(client, Json::array(), request.id);  // no names would be all of them
  else
    sendParameters(client, request.names, request.id);
}

/// Without names all parameters that there are; names of others are not kept.
void FoxgloveServer::subscribeParameters(Client& client, const std::vector<std::string>& names) {
  for (const auto& robot : robots_) {
    robot->parameters.merge(parametersOf(*robot));
    if (names.empty())
      for (const auto& [name, parameter] : robot->parameters) client.parameters.insert(name);
  }
  for (const std::string& name : names)
    if (const Robot* robot = robotOf(name); robot && robot->parameters.contains(name))
      client.parameters.insert(name);
}

/// Sends to each client which of a robot's parameters that it follows have changed.
void FoxgloveServer::notifyParameters(Robot& robot) {
  const auto before = std::exchange(robot.parameters, parametersOf(robot));
  Json changed = Json::object();
  for (const auto& [name, words] : robot.parameters) {
    const auto known = before.find(name);
    if (known != before.end() && known->second != words) changed[name] = parameterJson(name, words);
  }
  if (changed.empty()) return;
  for (const auto& [id, client] : clients_) {
    Json list = Json::array();
    for (const auto& [name, parameter] : changed.items())
      if (client.parameters.contains(name)) list.push_back(parameter);
    if (!list.empty()) sendParameters(id, std::move(list), "");
  }
}

/// Looks one robot after another up, since other tools may change parameters, too.
void FoxgloveServer::followParameters() {
  const bool followed = std::ranges::any_of(
      clients_, [](const auto& entry) { return !entry.second.parameters.empty(); });
  const auto now = Clock::now();
  if (!followed || robots_.empty() || now < parametersAsked_ + parameterInterval) return;
  parametersAsked_ = now;
  notifyParameters(*robots_[nextToAsk_++ % robots_.size()]);
}

}  // namespace gt
