#include "observer/robots/ReplayedSide.h"

#include <utility>

#include "logs/MessageTypes.h"

namespace gt {
namespace {

class ReplayedSide : public ComparedSide {
 public:
  explicit ReplayedSide(OpenedLog log) : log_{std::move(log)} {
    log_.platform.watchAll();
    static_cast<void>(log_.platform.robot().request(
        DebugRequest{"BehaviorControl/activations", DebugKeyMode::always, 0}));
  }

  Result<bool> next(const Handler& handle) override {
    auto more = log_.platform.step();
    if (!more || !*more) return more;
    now_ = log_.platform.now();
    MessageQueue& sent = log_.platform.robot().toTools();
    sent.handleAllMessages([&](const Message& message) {
      const RepresentationType* type = messageType(message.id);
      if (type && isCompared(*type)) handle(*type, false, message.time, message.bytes);
    });
    sent.clear();
    return true;
  }
  Time now() const override { return now_; }
  Time begin() const override { return begin_; }
  Time end() const override { return end_; }

 private:
  OpenedLog log_;
  const Time begin_ = log_.platform.player().begin(), end_ = log_.platform.player().end();
  Time now_ = begin_;
};

}  // namespace

Result<std::unique_ptr<ComparedSide>> replayedSide(
    const std::string& log, const LogRobotOptions& options,
    const std::vector<Configuration::SolutionChoice>& solutions) {
  auto opened = openLog(log, options, solutions);
  if (!opened) return opened.error();
  return std::unique_ptr<ComparedSide>{std::make_unique<ReplayedSide>(std::move(*opened))};
}

}  // namespace gt
