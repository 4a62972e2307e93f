#include "simulation/rules/GameController.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace gt {
namespace {

/// How one version's message is laid out, behind "RGme" and the version.
struct Format {
  int version;
  std::size_t size;
  bool words;           ///< All numbers have 32 bits.
  int wideVersion;      ///< Bytes of the version.
  int skipped;          ///< Bytes up to the state: packet number, players per team, ...
  bool stopFlag;        ///< The last but one of them states that the game is stopped.
  bool kickerByNumber;  ///< The team that kicks off is given by its number, not by its color.
  int teamSkipped;      ///< Bytes between a team's color and its score.
  int afterScore;       ///< Bytes between the score and the players.
  int players, playerSize;
};

constexpr std::array<Format, 7> formats{{
    {4, 120, true, 4, 0, false, false, 0, 0, 4, 8},
    {7, 116, false, 4, 1, false, false, 1, 0, 11, 4},
    {12, 54, false, 1, 5, false, true, 0, 3, 6, 2},
    {14, 62, false, 1, 5, false, true, 0, 5, 7, 2},
    {15, 118, false, 1, 5, false, true, 2, 5, 20, 2},
    {19, 198, false, 1, 5, true, true, 2, 5, 20, 4},
    {20, 158, false, 1, 5, true, true, 2, 5, 20, 3},
}};

const Format* formatOf(int version) {
  const int known = version > 15 && version < 19 ? 15 : version;
  const auto format = std::find_if(formats.begin(), formats.end(),
                                   [&](const Format& f) { return f.version == known; });
  return format == formats.end() ? nullptr : &*format;
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
                      : version <= 7  ? of2012
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
    const int penaltyBytes = format.wideVersion == 4 ? format.playerSize / 2 : 1;
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
  const auto wrong = [](std::string field, std::string what) {
    return Error{.file = "game controller", .field = std::move(field), .what = std::move(what)};
  };
  if (bytes.size() < 8 || std::memcmp(bytes.data(), "RGme", 4) != 0)
    return wrong("header", "is not RGme");
  GameControllerMessage message;
  message.version = std::to_integer<int>(bytes[4]);
  const Format* format = formatOf(message.version);
  if (!format)
    return wrong("version", std::to_string(message.version) + " is none of 4, 7, 12, 14 to 20");
  if (bytes.size() != format->size)
    return wrong(
        "", std::to_string(bytes.size()) + " bytes instead of " + std::to_string(format->size));

  const int width = format->words ? 4 : 1;
  Reader reader{bytes.subspan(4 + static_cast<std::size_t>(format->wideVersion))};
  bool stopped = false;
  for (int i = 0; i < format->skipped; ++i) {
    const bool set = reader.number(1) != 0;
    if (format->stopFlag && i + 2 == format->skipped) stopped = set;
  }
  const std::uint32_t state = reader.number(width);
  using enum GameState;
  constexpr std::array<GameState, 6> states{initial, ready, set, playing, finished, initial};
  if (state >= states.size()) return wrong("state", std::to_string(state) + " is unknown");
  message.state = stopped && states[state] == playing ? set : states[state];
  if (format->kickerByNumber) reader.skip(1);  // the set play
  message.firstHalf = reader.number(width) != 0;
  const std::uint32_t kicker = reader.number(width);
  if (format->version == 7) reader.skip(4);  // shoot-out, drop-in
  const int timeBytes = format->version <= 7 ? 4 : 2;
  const std::uint32_t seconds = reader.number(timeBytes);
  message.secondsLeft = timeBytes == 2
                            ? static_cast<std::int16_t>(static_cast<std::uint16_t>(seconds))
                            : std::clamp(static_cast<std::int32_t>(seconds), -86'400, 86'400);
  reader.skip(format->version == 4 ? 8 : format->version == 7 ? 0 : 2);

  const ReadTeam first = readTeam(reader, *format, message.version),
                 second = readTeam(reader, *format, message.version);
  constexpr std::uint32_t blue = 0, red = 1;
  const bool firstIsRed = first.color == red || (first.color != blue && second.color == blue);
  const TeamColor firstColor = firstIsRed ? TeamColor::red : TeamColor::blue;
  message.teams[firstColor] = first.team;
  message.teams[opponent(firstColor)] = second.team;
  if (!format->kickerByNumber) {
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
    constexpr std::uint32_t alive = 0;
    append(bytes, 3, 1);
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
