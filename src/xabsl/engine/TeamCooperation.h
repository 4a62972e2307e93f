#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "xabsl/language/Model.h"

namespace xabsl {

/// The message of an engine to the engines of its teammates after each cycle. All engines must run
/// the same behavior: the marks are in the order of its cooperative states.
struct CooperationMessage {
  enum Mark : std::uint8_t {
    optionExecuted = 1,  ///< the option of the state was active
    executing = 2,       ///< the state was active
    entering = 4         // the decisions chose the state, but the team has not agreed yet
  };

  double priority = 0;
  std::vector<std::uint8_t> marks;
};

/// Negotiates with teammates which robots enter a cooperative state. The engine queries it, the
/// host carries the messages. Nothing is allocated after construction.
class TeamCooperation {
 public:
  explicit TeamCooperation(const Model& model);

  /// If several robots want the last places of a state, the largest priority comes first. Equal
  /// priorities keep all of them out, so they must differ. A state with a capacity is entered after
  /// it was announced for `synchronizationTicks` cycles, a synchronized one after more than half.
  void configure(double priority, int synchronizationTicks);
  int synchronizationTicks() const { return synchronizationTicks_; }

  /// Selects the robots that `synchronized n` counts: by default n robots including this one, as in
  /// some engines of other teams; with true n teammates in addition to it, as in the stock engine
  /// of XABSL 3.1.
  void countTeammatesOnly(bool only) { countsTeammatesOnly_ = only; }
  bool countsTeammatesOnly() const { return countsTeammatesOnly_; }

  /// Replaces all earlier messages by the latest one of each teammate. Missing marks are 0.
  void receive(const std::vector<CooperationMessage>& messages);

  const CooperationMessage& message() const { return message_; }

  void beginCycle();
  void markOption(int option, int state);

  /// Returns whether a state may be entered in this cycle; if not, announces it to the team.
  bool mayEnter(int state);

  /// Returns whether a state with a capacity is full with other robots alone.
  bool conflict(int state) const;

 private:
  struct Member {
    int option = -1;
    int state = -1;
    Cooperation cooperation;
    bool entering = false;  ///< in this cycle
    int announced = 0;      ///< number of consecutive cycles before this one
    int othersInOption = 0;
    int othersExecuting = 0;
    int othersEntering = 0;
    double largestPriority = 0;  ///< of the robots entering
  };

  bool hasPlace(Member& member) const;
  bool isTogether(Member& member) const;

  std::vector<Member> members_;
  std::vector<int> memberOfState_;  ///< -1: not cooperative
  CooperationMessage message_;
  int synchronizationTicks_ = 0;
  bool countsTeammatesOnly_ = false;
};

}  // namespace xabsl
