#include "simulation/rules/GameController.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace gt {
namespace {

/// The layout of one version's message, behind "RGme".
struct Format {
  int version;
  std::size_t size;
  int versionBytes;
  int skipped;          ///< Bytes up to the state: packet number, players per team, ...
  bool setPlay;         ///< A byte between the state and the half.
  bool kickerByNumber;  ///< The team that kicks off is given by its number, not by its color.
  int afterKicker;      ///< Bytes up to the time: shoot-out, drop-in.
  int timeBytes;
  int afterTime;    ///< Bytes up to the teams.
  int teamSkipped;  ///< Bytes between a team's color and its score.
  int afterScore;   ///< Bytes between the score and the players: shots, message of the coach.
  int players, playerSize;
  bool words = false;  ///< All numbers have 32 bits.
  bool stopFlag =
      false;  ///< The last but one of the skipped bytes states that the game is stopped.
};

/// Some versions were used with messages of a coach of two sizes.
constexpr std::array<Format, 11> formats{{
    {4, 120, 4, 0, false, false, 0, 4, 8, 0, 0, 4, 8, true},
    {7, 116, 4, 1, false, false, 4, 4, 0, 1, 0, 11, 4},
    {8, 158, 1, 2, false, false, 4, 2, 2, 0, 45, 11, 2},
    {9, 244, 2, 3, false, true, 4, 2, 2, 0, 87, 11, 2},
    {9, 588, 2, 3, false, true, 4, 2, 2, 0, 259, 11, 2},
    {11, 58, 2, 5, true, true, 3, 2, 2, 0, 3, 6, 2},
    {12, 54, 1, 5, true, true, 0, 2, 2, 0, 3, 6, 2},
    {14, 62, 1, 5, true, true, 0, 2, 2, 0, 5, 7, 2},
    {15, 118, 1, 5, true, true, 0, 2, 2, 2, 5, 20, 2},
    {19, 198, 1, 5, true, true, 0, 2, 2, 2, 5, 20, 4, false, true},
    {20, 158, 1, 5, true, true, 0, 2, 2, 2, 5, 20, 3, false, true},
}};

Error wrongMessage(std::string field, std::string what) {
  return {.file = "game controller", .field = std::move(field), .what = std::move(what)};
}

Result<const Format*> formatOf(int version, std::size_t size) {
  const int known = version > 15 && version < 19 ? 15 : version;
  std::string sizes;
  for (const Format& format : formats) {
    if (format.version != known) continue;
    if (format.size == size) return &format;
    sizes += (sizes.empty() ? "" : " or ") + std::to_string(format.size);
  }
  const std::string number = std::to_string(version);
  if (sizes.empty())
    return wrongMessage("version", number + " is none of 4, 7 to 9, 11, 12, 14 to 20");
  return wrongMessage(
      "size", std::to_string(size) + " bytes instead of " + sizes + " of version " + number);
}

/// Reads little endian numbers; behind the end all are 0.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint32_t number(int bytes) {
    std::uint32_t value = 0;
    for (int i = 0; i < bytes; ++i, ++at_)
      if (at_ < bytes_.size()) value |= std::to_integer<std::uint32_t>(bytes_[at_]) << 8 * i;
    return value;
  }
  void skip(int bytes) { at_ += static_cast<std::size_t>(bytes); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

Penalty penaltyOf(int version, std::uint32_t number) {
  using enum Penalty;
  // By version, from 1 on.
  static const std::vector<Penalty> of2005{ballHolding,     keeperCharge,   fieldPlayerCharge,
                                           illegalDefender, illegalDefense, obstruction},
      of2012{ballHolding,     fieldPlayerCharge, obstruction, requestForPickup,
             illegalDefender, requestForPickup,  ballHolding},
      of2019{ballHolding,     fieldPlayerCharge, illegalDefense,   requestForPickup,
             illegalDefender, requestForPickup,  requestForPickup, requestForPickup,
             obstruction,     illegalDefender},
      of2022{ballHolding,     fieldPlayerCharge, illegalDefense,   requestForPickup,
             illegalDefender, requestForPickup,  requestForPickup, obstruction,
             illegalDefense,  requestForPickup,  illegalDefense},
      of2025{illegalDefender, illegalDefense,   obstruction, requestForPickup, requestForPickup,
             ballHolding,     requestForPickup, ballHolding, fieldPlayerCharge},
      of2026{illegalDefender,  illegalDefense, illegalDefense,   obstruction, requestForPickup,
             requestForPickup, ballHolding,    requestForPickup, ballHolding, fieldPlayerCharge};
  const auto& known = version <= 4    ? of2005
                      : version <= 8  ? of2012
                      : version <= 12 ? of2019
                      : version < 19  ? of2022
                      : version == 19 ? of2025
                                      : of2026;
  if (number == 0) return none;
  return number <= known.size() ? known[number - 1] : requestForPickup;
}

/// A team as it stands in the message.
struct ReadTeam {
  GameControllerMessage::Team team;
  std::uint32_t color = 0;
};

ReadTeam readTeam(Reader& reader, const Format& format, int version) {
  const int width = format.words ? 4 : 1;
  ReadTeam read;
  read.team.number = static_cast<int>(reader.number(width));
  read.color = reader.number(width);
  reader.skip(format.teamSkipped);
  read.team.score = static_cast<int>(std::min(reader.number(width), 999u));
  reader.skip(format.afterScore);
  for (int i = 0; i < format.players; ++i) {
    const int penaltyBytes = format.versionBytes == 4 ? format.playerSize / 2 : 1;
    const Penalty penalty = penaltyOf(version, reader.number(penaltyBytes));
    if (i < 4) read.team.penalties[static_cast<std::size_t>(i)] = penalty;
    reader.skip(format.playerSize - penaltyBytes);
  }
  return read;
}

void append(std::vector<std::byte>& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::byte>(value >> 8 * i));
}

void append(std::vector<std::byte>& bytes, double value) {
  append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}

}  // namespace

Result<GameControllerMessage> parseGameController(std::span<const std::byte> bytes) {
  if (bytes.size() < 8 || std::memcmp(bytes.data(), "RGme", 4) != 0)
    return wrongMessage("header", "is not RGme");
  GameControllerMessage message;
  message.version = std::to_integer<int>(bytes[4]);
  const auto found = formatOf(message.version, bytes.size());
  if (!found) return found.error();
  const Format& format = **found;

  const int width = format.words ? 4 : 1;
  Reader reader{bytes.subspan(4 + static_cast<std::size_t>(format.versionBytes))};
  bool stopped = false;
  for (int i = 0; i < format.skipped; ++i) {
    const auto value = static_cast<int>(reader.number(1));
    if (i == 0 && message.version >= 8) message.packet = value;
    if (format.stopFlag && i + 2 == format.skipped) stopped = value != 0;
  }
  const std::uint32_t state = reader.number(width);
  using enum GameState;
  constexpr std::array<GameState, 6> states{initial, ready, set, playing, finished, initial};
  if (state >= states.size()) return wrongMessage("state", std::to_string(state) + " is unknown");
  message.state = stopped && states[state] == playing ? set : states[state];
  if (format.setPlay) reader.skip(1);
  message.firstHalf = reader.number(width) != 0;
  const std::uint32_t kicker = reader.number(width);
  reader.skip(format.afterKicker);
  const std::uint32_t seconds = reader.number(format.timeBytes);
  message.secondsLeft = format.timeBytes == 2
                            ? static_cast<std::int16_t>(static_cast<std::uint16_t>(seconds))
                            : std::clamp(static_cast<std::int32_t>(seconds), -86'400, 86'400);
  reader.skip(format.afterTime);

  const ReadTeam first = readTeam(reader, format, message.version),
                 second = readTeam(reader, format, message.version);
  constexpr std::uint32_t blue = 0, red = 1;
  const bool firstIsRed = first.color == red || (first.color != blue && second.color == blue);
  const TeamColor firstColor = firstIsRed ? TeamColor::red : TeamColor::blue;
  message.teams[firstColor] = first.team;
  message.teams[opponent(firstColor)] = second.team;
  if (!format.kickerByNumber) {
    if (kicker <= red) message.kickOff = kicker == red ? TeamColor::red : TeamColor::blue;
  } else {
    for (const TeamColor team : {TeamColor::red, TeamColor::blue})
      if (static_cast<int>(kicker) == message.teams[team].number) message.kickOff = team;
  }
  return message;
}

std::vector<std::byte> answerBytes(const GameControllerAnswer& answer, int version) {
  std::vector<std::byte> bytes;
  if (version <= 4) return bytes;
  for (const char c : {'R', 'G', 'r', 't'}) bytes.push_back(static_cast<std::byte>(c));
  const auto team = static_cast<std::uint32_t>(answer.team),
             player = static_cast<std::uint32_t>(answer.player);
  if (version <= 7) {
    constexpr std::uint32_t alive = 2;
    append(bytes, 1, 4);
    append(bytes, team, 2);
    append(bytes, player, 2);
    append(bytes, alive, 4);
  } else if (version <= 12) {
    const bool old = version <= 9;
    const std::uint32_t alive = old ? 2 : 0;
    append(bytes, old ? 2 : 3, 1);
    append(bytes, team, 1);
    append(bytes, player, 1);
    append(bytes, alive, 1);
  } else {
    append(bytes, 4, 1);
    append(bytes, player, 1);
    append(bytes, team, 1);
    append(bytes, answer.fallen, 1);
    append(bytes, answer.pose.translation.x());
    append(bytes, answer.pose.translation.y());
    append(bytes, answer.pose.rotation);
    append(bytes, answer.ballAge);
    append(bytes, answer.ball.x());
    append(bytes, answer.ball.y());
  }
  return bytes;
}

}  // namespace gt
