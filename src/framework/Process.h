#pragma once
#include <string>
#include <vector>

#include "framework/Package.h"

namespace gt {

/// A process of a robot (report C.2): waits for its blocking senders and receivers, then goes
/// through the three phases of report 2.2.3.1 (receive, main(), send). Runs as a program of its own
/// or under a scheduler.
class Process {
 public:
  explicit Process(std::string name) : name_{std::move(name)} {}
  virtual ~Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Runs the three phases if the time has come and no blocking sender or receiver holds it up.
  /// True if main() ran.
  bool step(Time now);

  const std::string& name() const { return name_; }
  Time now() const { return now_; }

  void enlist(PackageSender& sender) { senders_.push_back(&sender); }
  void enlist(PackageReceiver& receiver) { receivers_.push_back(&receiver); }

 protected:
  /// The process's work. Returns the milliseconds to wait before the next call, negative for a
  /// cycle time from call to call, 0 to be called again only when a blocking receiver has got a
  /// package.
  virtual int main() = 0;

 private:
  bool ready() const;

  std::string name_;
  std::vector<PackageSender*> senders_;
  std::vector<PackageReceiver*> receivers_;
  Time now_;
  Time next_;
  bool waitsForPackage_ = false;
};

}  // namespace gt
