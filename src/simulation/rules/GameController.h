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

/// The message that the RoboCup game controller sends to all robots, in any of its formats: RGme of
/// 2005 (version 4), 2012 (7), 2014 (8), 2015 and 2016 (9), 2018 (11), 2019 (12), 2022 (14), 2023
/// to 2025 (15 to 18), and those of the humanoid league (19, 20). It is sent by UDP to port 3838,
/// several times a second.
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
  std::optional<TeamColor> kickOff;  ///< Empty if neither team has the kick-off.
  int secondsLeft = 0;               ///< In this half.
  EnumArray<TeamColor, Team> teams;
};

/// Parses a message. Teams are distinguished by their color, or if that is neither red nor blue, by
/// their place: blue is the first. Penalties that 2003 did not know become those nearest to them; a
/// robot that was taken off for a reason of its own gets the penalty request for pick-up. Fails if
/// the bytes are no message of the game controller.
Result<GameControllerMessage> parseGameController(std::span<const std::byte> bytes);

/// The answer of a robot to the game controller.
struct GameControllerAnswer {
  int team = 0;    ///< The team's number.
  int player = 1;  ///< From 1.
  bool fallen = false;
  Pose2D pose;                       ///< mm, in the team's coordinates
  double ballAge = -1;               ///< s since it saw the ball; -1 if it never did
  Vector2d ball = Vector2d::Zero();  ///< mm, relative to the robot
};

/// Encodes an answer (RGrt) for a game controller of a version; empty if that version expects no
/// answers.
std::vector<std::byte> answerBytes(const GameControllerAnswer& answer, int version);

/// The UDP ports to which messages and answers are sent.
constexpr int gameControllerPort = 3838;
constexpr int gameControllerAnswerPort(int version) {
  return version <= 8 ? gameControllerPort : 3939;
}

}  // namespace gt
