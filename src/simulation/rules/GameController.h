#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Result.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// What the RoboCup game controller sends all robots, in whichever of its formats: RGme of 2005
/// (version 4), 2012 (7), 2014 (8), 2015 and 2016 (9), 2018 (11), 2019 (12), 2022 (14), 2023 to
/// 2025 (15 to 18), and those of the humanoid league (19, 20). Sent by UDP to port 3838, some times
/// a second.
struct GameControllerMessage {
  struct Team {
    int number = 0;
    int score = 0;
    std::array<Penalty, 4> penalties{};  ///< Of players 1 to 4, as the rules of 2003 call them.

    friend bool operator==(const Team&, const Team&) = default;
  };

  int version = 0;
  std::optional<int> packet;  ///< Counts the messages, modulo 256; empty in versions 4 and 7.
  GameState state = GameState::initial;
  bool firstHalf = true;
  std::optional<TeamColor> kickOff;  ///< None if it is neither's.
  int secondsLeft = 0;               ///< In this half.
  EnumArray<TeamColor, Team> teams;
};

/// Reads a message. Teams are distinguished by their color, or if that is neither red nor blue, by
/// their place: blue is the first. Penalties that 2003 did not know become those nearest to them;
/// whoever is taken off for a reason of its own requests for pick-up. Fails if the bytes are no
/// such message.
Result<GameControllerMessage> parseGameController(std::span<const std::byte> bytes);

/// What a robot answers.
struct GameControllerAnswer {
  int team = 0;    ///< The team's number.
  int player = 1;  ///< From 1.
  bool fallen = false;
  Pose2D pose;                       ///< mm, in the team's coordinates
  double ballAge = -1;               ///< s since it saw the ball; -1 never
  Vector2d ball = Vector2d::Zero();  ///< mm, relative to the robot
};

/// The answer as bytes (RGrt), as a controller of that version understands it; empty if it hears no
/// answers.
std::vector<std::byte> answerBytes(const GameControllerAnswer& answer, int version);

/// Where messages are sent to, and answers.
constexpr int gameControllerPort = 3838;
constexpr int gameControllerAnswerPort(int version) {
  return version <= 8 ? gameControllerPort : 3939;
}

}  // namespace gt
