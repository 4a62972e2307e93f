#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "debug/Stopwatch.h"
#include "framework/Description.h"
#include "framework/Layout.h"
#include "framework/Process.h"
#include "framework/RequestTypes.h"

namespace gt {

/// A process that runs the modules of a layout over its blackboard.
class ModuleProcess : public Process {
 public:
  /// The blackboard must contain the configuration. `frameTime`, which lies on the blackboard, is
  /// set at the begin of each cycle. Each module gets its own random number generator, forked by
  /// the task's name.
  ModuleProcess(const Plan::Process& plan, Blackboard blackboard, Time& frameTime,
                const Random& random);

  /// The process's end of a connection, for the platform or another process to connect.
  PackageSender& sender(const RepresentationType& type);
  PackageReceiver& receiver(const RepresentationType& type, bool blocking);
  /// The message queues to and from the Debug process.
  PackageSender& debugSender() { return debugSender_; }
  PackageReceiver& debugReceiver() { return debugReceiver_; }

  using Requests = RequestTypes<SolutionRequest, DebugRequest, WatchRequest, ValueRequest,
                                ParameterRequest, DescriptionRequest, GenericDebugData>;
  /// Whether a request is addressed to this process; see Requests.h.
  bool concerns(const SolutionRequest& request) const { return solves(request.task); }
  bool concerns(const DebugRequest& request) const { return DebugKey::find(request.key); }
  bool concerns(const WatchRequest& request) const;
  bool concerns(const ValueRequest& request) const;
  bool concerns(const ParameterRequest& request) const { return solves(request.task); }
  bool concerns(const DescriptionRequest& request) const;
  bool concerns(const GenericDebugData& data) const;
  /// Executes a request that concerns this process. Requests are also accepted as messages.
  Result<void> request(const SolutionRequest& request);
  Result<void> request(const DebugRequest& request);
  Result<void> request(const WatchRequest& request);
  Result<void> request(const ValueRequest& request);
  Result<void> request(const ParameterRequest& request);
  Result<void> request(const DescriptionRequest& request);
  Result<void> request(const GenericDebugData& data);
  /// Reads a solution's parameters from a configuration file's text.
  Result<void> configure(std::string_view task, std::string_view solution, std::string_view text,
                         const std::string& file);

  /// Executes messages of the tools immediately, between two cycles. The answers are appended to
  /// `answers`.
  void carryOut(const MessageQueue& messages, MessageQueue& answers);

  bool solves(std::string_view task) const;
  /// The name of the active solution; empty if the process has no such task.
  std::string activeSolution(std::string_view task) const;
  /// A parameter as text.
  Result<std::string> parameter(std::string_view task, std::string_view solution,
                                std::string_view path);
  /// A parameter as a value, which is valid until the parameter is set.
  Result<ConstValue> parameterValue(std::string_view task, std::string_view solution,
                                    std::string_view path);
  /// Describes all tasks, or only the given one.
  ProcessDescription describe(std::string_view task = {});
  /// Handles messages of the tools that the framework does not know. Returns false for unknown
  /// ones.
  using Handler = std::function<bool(const Message&)>;
  void onMessage(Handler handler) { handler_ = std::move(handler); }
  /// Called after tools have set a representation that is not received, or a field of it.
  using ChangeHandler = std::function<void(const RepresentationType&)>;
  void onChange(ChangeHandler handler) { changed_ = std::move(handler); }
  /// The representations that are sent after cycles, with their rates.
  std::vector<WatchRequest> watched() const;
  /// Whether the process has a task that provides the representation, but is disabled.
  bool isDisabled(const RepresentationType& type) const;
  /// Sets the output of a disabled task; returns whether the process has such a task.
  bool layIfDisabled(const RepresentationType& type, const void* value);
  /// Copies the outputs of its modules to another blackboard, as far as that has them.
  void copyProvided(Blackboard& to);
  /// Resumes from a process that had some of the same tasks: takes over the state of their modules,
  /// the held values, and the debug keys.
  void adopt(ModuleProcess& other);
  Blackboard& blackboard() { return blackboard_; }
  Debug& debug() { return debug_; }
  /// The execution time of each module, by task, in the order of execution.
  const std::vector<Stopwatch>& times() const { return times_.modules; }
  /// Answers a message of the tools, for use by handlers.
  void answer(const Message& message, const Result<void>& done) {
    send(answerTo(message, name(), done));
  }
  void answerNotConcerned(const Message& message) { send(notConcerned(message, name())); }
  /// Sets the number of processes that answer each request, so that tools know when all have.
  void answerAsOneOf(std::uint32_t processes) { answering_ = processes; }

 protected:
  int main() override;

 private:
  struct Slot {
    const Task* task;
    const RepresentationType* trigger;  ///< Null: runs in each cycle.
    std::vector<std::unique_ptr<AnyModule>> solutions;
    AnyModule* active = nullptr;
  };
  struct Watched {
    const RepresentationType* type;
    const Blackboard::Slot* slot;  ///< Null for ModuleTimes.
    DebugKeyState state;
  };
  struct Held {
    const RepresentationType* type;
    std::string path, value;
  };

  const Slot* find(std::string_view task) const;
  Slot* find(std::string_view task);
  Result<AnyModule*> find(std::string_view task, std::string_view solution);
  Result<void> checkInputs(const Task& task, std::string_view solution) const;
  bool isDue(const Slot& slot) const;
  void run(Slot& slot);
  void handle(const Message& message);
  void send(RequestAnswer answer);
  void handlePackage(const Message& message);
  /// Sends the watched representations that are due: all, or only those in the mode `times`.
  void sendWatched(bool onlyTimes);
  bool provides(const RepresentationType& type) const;
  RepresentationOrigin originOf(const RepresentationType& type) const;
  Result<void> setField(const RepresentationType& type, const std::string& path,
                        const std::string& value);
  void setHeld(const RepresentationType& type);

  Blackboard blackboard_;
  Debug debug_;
  Time& frameTime_;
  std::vector<Slot> slots_;
  std::vector<const RepresentationType*> platform_, missing_, answersFor_;
  ModuleTimes times_;
  std::vector<Watched> watched_;
  std::vector<Held> held_;
  std::vector<std::unique_ptr<PackageSender>> ownSenders_;
  std::vector<std::unique_ptr<PackageReceiver>> ownReceivers_;
  Handler handler_;
  ChangeHandler changed_;
  std::uint32_t answering_ = 1;
  MessageQueue debugIn_, debugOut_;
  PackageSender debugSender_;
  PackageReceiver debugReceiver_;
};

}  // namespace gt
