#pragma once
#include <vector>

#include "base/Random.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/Player.h"
#include "simulation/parameters/RadioParameters.h"

namespace gt {

/// The wireless network: carries team messages to the sender's teammates, to each with a delay and
/// a chance of loss of its own. All robots' clocks are the simulator's, so times need no
/// conversion.
class Radio {
 public:
  Radio(const RadioParameters& parameters, const std::vector<Player>& players,
        const Random& random);

  /// Sends a message to the sender's teammates. The network enters the sender's number.
  void send(std::size_t sender, const TeamMessage& message, Time now);

  /// Moves the messages that have arrived for a robot to `messages`. A message that was overtaken
  /// by a newer one of the same sender is dropped. May run for several robots at once.
  void receive(std::size_t robot, Time now, TeamMessages& messages);

  std::size_t lost() const { return lost_; }

  const RadioParameters& parameters() const { return parameters_; }
  /// Sets the parameters for messages that are sent from now on.
  void change(const RadioParameters& parameters) { parameters_ = parameters; }
  /// Cuts one robot off from the network, or connects it again.
  void cut(std::size_t robot, bool off) { off_[robot] = off; }
  bool isCut(std::size_t robot) const { return off_[robot]; }

 private:
  struct Underway {
    Time due;
    TeamMessage message;
  };

  RadioParameters parameters_;
  std::vector<Player> players_;
  std::vector<std::vector<Underway>> underway_;  ///< By receiver.
  std::vector<bool> off_;                        ///< Robots cut off.
  /// Whether the network is down at the moment.
  bool isDown(Time now);

  Random random_, breakdowns_;
  bool down_ = false;
  Time changesAt_ = never();
  std::size_t lost_ = 0;
};

}  // namespace gt
