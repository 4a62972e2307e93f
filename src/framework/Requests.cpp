#include "framework/Requests.h"

#include <utility>

namespace gt {

RequestAnswer answerTo(const Message& request, std::string process, const Result<void>& done) {
  return {request.id, request.time, std::move(process),
          done ? RequestOutcome::done : RequestOutcome::refused,
          done ? std::string{} : done.error().text()};
}

RequestAnswer notConcerned(const Message& request, std::string process) {
  return {request.id, request.time, std::move(process), RequestOutcome::notConcerned, {}};
}

Error concernsNobody(const SolutionRequest& request) {
  return {.field = request.task, .what = "no process solves this task"};
}
Error concernsNobody(const DebugRequest& request) {
  return {.field = request.key, .what = "there is no such debug key"};
}
Error concernsNobody(const WatchRequest& request) {
  if (request.process.empty())
    return {.field = request.representation, .what = "no process of the robot has it"};
  return {.field = request.process, .what = "there is no such process"};
}
Error concernsNobody(const ValueRequest& request) {
  return {.field = request.representation, .what = "no process of the robot has it"};
}
Error concernsNobody(const ParameterRequest& request) {
  return {.field = request.task, .what = "no process solves this task"};
}
Error concernsNobody(const DescriptionRequest& request) {
  return {.field = request.about, .what = "there is no such process or task"};
}
Error concernsNobody(const GenericDebugData& data) {
  return {.field = data.id, .what = "no process solves this task"};
}

}  // namespace gt
