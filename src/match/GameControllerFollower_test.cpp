#include "match/GameControllerFollower.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

#include "match/TestMatch.h"

namespace gt {
namespace {

using GameControllerFollowerTest = MatchTest;

/// A game controller's message of 2019: state, score of blue, the first team, and seconds left.
std::vector<std::byte> order(int state, int score, int seconds = 60) {
  const std::string head{"RGme"};
  std::vector<std::byte> bytes(54);
  for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<std::byte>(head[i]);
  for (const auto& [at, value] : std::map<std::size_t, int>{{4, 12},
                                                            {10, state},
                                                            {12, 1},
                                                            {13, 5},
                                                            {14, seconds % 256},
                                                            {15, seconds / 256},
                                                            {18, 5},
                                                            {20, score},
                                                            {36, 7},
                                                            {37, 1}})
    bytes[at] = static_cast<std::byte>(value);
  return bytes;
}

/// A game controller on an address of its own of this machine, where nobody else listens.
class Controller {
 public:
  explicit Controller(std::uint32_t number = 0) {
    address_.sin_family = AF_INET;
    address_.sin_addr.s_addr =
        htonl(0x7f800001u + ((static_cast<std::uint32_t>(::getpid()) & 0x1fffff) << 2) + number);
    address_.sin_port = htons(gameControllerAnswerPort(12));
    const auto* address = reinterpret_cast<const sockaddr*>(&address_);
    EXPECT_EQ(::bind(socket_, address, sizeof address_), 0) << std::strerror(errno);
  }
  ~Controller() { ::close(socket_); }
  void send(std::span<const std::byte> bytes, int port) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    ::sendto(socket_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
  }
  /// How many answers have come.
  int answers() const {
    int count = 0;
    char answer[64];
    while (::recv(socket_, answer, sizeof answer, MSG_DONTWAIT) == 8)
      count += std::memcmp(answer, "RGrt", 4) == 0;
    return count;
  }

 private:
  int socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address_{};
};

TEST_F(GameControllerFollowerTest, AGameControllerLeadsByUdpAndIsAnswered) {
  MatchOptions options;
  options.minutes = 1;
  options.gameController = "0";
  auto made = Match::make(options);
  ASSERT_TRUE(made) << made.error().text();
  Match& match = **made;
  ASSERT_TRUE(match.gameControllerPort());
  const Controller controller;
  controller.send(std::as_bytes(std::span{"garbage"}), *match.gameControllerPort());
  match.step();
  EXPECT_FALSE(match.simulation().referee().led());
  EXPECT_EQ(controller.answers(), 0);
  controller.send(order(3, 2), *match.gameControllerPort());
  match.step();
  const Referee& referee = match.simulation().referee();
  EXPECT_TRUE(referee.led());
  EXPECT_EQ(referee.state(), GameState::playing);
  EXPECT_EQ(referee.score(TeamColor::blue), 2);
  EXPECT_EQ(referee.kickOff(), TeamColor::blue);
  EXPECT_EQ(controller.answers(), 8);
  // The same again changes nothing, but is answered.
  controller.send(order(3, 2), *match.gameControllerPort());
  match.step();
  EXPECT_EQ(match.history().size(), 1u);
  EXPECT_EQ(controller.answers(), 8);
  // Its message is part of the state.
  for (int i = 0; i < 20; ++i) match.step();
  const std::string file = (folder / "led.state").string();
  ASSERT_TRUE(match.save(file));
  const auto loaded = Match::load(file, {}, putBall);
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_EQ((*loaded)->simulation().referee().score(TeamColor::blue), 2);
  EXPECT_FALSE((*loaded)->gameControllerPort()) << "nobody may lead this one";
}

/// A match that a game controller may lead.
class LedMatch : public MatchTest {
 protected:
  void begin(const MatchOptions& changed = {}) {
    MatchOptions options = changed;
    options.minutes = 1;
    options.gameController = "0";
    auto made = Match::make(options);
    ASSERT_TRUE(made) << made.error().text();
    match = std::move(*made);
  }
  void send(const std::vector<std::byte>& bytes, const Controller& from) {
    from.send(bytes, *match->gameControllerPort());
    match->step();
  }
  double secondsLeft() const {
    return static_cast<double>(match->simulation().referee().timeLeft(match->time())) / 1000;
  }

  std::unique_ptr<Match> match;
  const Controller controller;
};

TEST_F(LedMatch, ItsClockIsSet) {
  begin();
  send(order(3, 0, 600), controller);
  for (int i = 0; i < 125; ++i) match->step();
  EXPECT_NEAR(secondsLeft(), 599, 0.1);
  send(order(3, 0, 598), controller);
  EXPECT_NEAR(secondsLeft(), 599, 0.1) << "it passes by itself";
  send(order(3, 0, 610), controller);
  EXPECT_NEAR(secondsLeft(), 610, 0.1) << "it was set back";
  EXPECT_EQ(match->history().size(), 2u);
}

TEST_F(LedMatch, OverlapsWithNoOtherController) {
  begin();
  const Controller other{1};
  const int port = *match->gameControllerPort();
  controller.send(order(3, 1), port);
  for (int i = 0; i < 3; ++i) other.send(order(1, 0), port);
  match->step();  // takes them all: none of both is silent, however slow the machine is
  EXPECT_EQ(match->simulation().referee().state(), GameState::playing);
  EXPECT_EQ(match->simulation().referee().score(TeamColor::blue), 1);
  EXPECT_EQ(other.answers(), 0);
  EXPECT_EQ(match->takeGameControllerNews().size(), 2u);
}

TEST_F(LedMatch, RobotsWhoseProgramsNeverCameDoNotAnswer) {
  MatchOptions options;
  options.remote = {{"red3", ""}, {"blue1", ""}};
  options.sockets = (folder / "sockets").string();
  begin(options);
  send(order(3, 0), controller);
  EXPECT_EQ(controller.answers(), 6);
}

}  // namespace
}  // namespace gt
