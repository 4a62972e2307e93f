#pragma once
#include <functional>
#include <string>
#include <vector>

#include "framework/Package.h"

namespace gt {

/// A process of a robot (report C.2): waits for its blocking senders and receivers, then executes
/// the three phases of report 2.2.3.1 (receive, main(), send). Runs as a program of its own or
/// under a scheduler.
class Process {
 public:
  explicit Process(std::string name) : name_{std::move(name)} {}
  virtual ~Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// The platform's clock.
  using Clock = std::function<Time()>;

  /// Executes the three phases if the time has come and no blocking sender or receiver must be
  /// waited for. Returns whether main() was executed.
  bool stepBy(const Clock& clock);
  /// Like stepBy, for platforms on which main() takes no time, such as a simulator.
  bool step(Time now);

  const std::string& name() const { return name_; }
  /// Begin of the present cycle.
  Time now() const { return now_; }
  /// Earliest time of the next call of main().
  Time next() const { return next_; }

  void add(PackageSender& sender) { senders_.push_back(&sender); }
  void add(PackageReceiver& receiver) { receivers_.push_back(&receiver); }

 protected:
  /// The process's work (report C.2). Returns the time (ms) to wait from its end to the next call;
  /// negative for a cycle time from call to call; 0 to be called again only when a blocking
  /// receiver has received a package or a blocking sender was requested to send one.
  virtual int main() = 0;

 private:
  bool ready() const;
  void schedule(int wait, Time end);

  std::string name_;
  std::vector<PackageSender*> senders_;
  std::vector<PackageReceiver*> receivers_;
  Time now_;
  Time next_ = never();
  bool waitsForPackage_ = false;
};

}  // namespace gt
