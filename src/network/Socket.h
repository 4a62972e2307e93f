#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/Enum.h"
#include "framework/Representation.h"
#include "network/Frame.h"

namespace gt {

class Network;

/// A message as it came in; views into the socket's memory until the next one.
struct Received {
  std::string_view peer;     ///< Who sent it, where several may; empty otherwise.
  std::string_view address;  ///< Of the sender, as far as it is known: of IP.
  Frame frame;
};

/// Why somebody is not let in, or is sent away.
enum class Refusal { wrongKey, unknownKey, otherUser, noPlace, share, endless, silent };
/// How many were, for each reason.
using Refusals = EnumArray<Refusal, std::uint64_t>;
/// A reason in words.
std::string_view describe(Refusal reason);
/// How many were refused, and why: "3 refused: 2 sent nothing, 1 ..."; empty if nobody was.
std::string describe(const Refusals& refusals);

/// What a frame is about: the packages of a type for one receiver.
struct Topic {
  Topic(const RepresentationType& t, std::uint32_t number = 0)  // NOLINT: a type is a topic
      : type{&t}, schema{t.schema().id()}, receiver{number} {}

  const RepresentationType* type;
  std::uint32_t schema;    ///< Its id.
  std::uint32_t receiver;  ///< Counts the receivers of a process for the type.
};

/// How much a socket holds for others.
struct SocketLimits {
  int frames = 64;                     ///< In each direction, for each peer; more are dropped.
  std::int64_t frameSize = 4'000'000;  ///< A larger frame ends the connection.
  std::size_t peers = 64;              ///< Who comes later is not let in.
  std::size_t peersOfOne = 32;         ///< Of one address of IP, so that others have places, too.
};

/// One end of connections: listening for many peers, or connected to one. Never waits. Made by
/// Network.
class Socket {
 public:
  virtual ~Socket() = default;
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  /// Sends a package, or without a value a frame without one. False if it was dropped since the
  /// peer is not there or does not keep up.
  virtual bool send(std::string_view peer, FrameKind kind, const Topic& topic,
                    const void* value) = 0;
  /// The next frame that came in; messages that are none are counted and passed over.
  virtual bool receive(Received& received) = 0;
  /// Where it listens; for tcp with the port that was chosen if it was asked for port 0.
  virtual std::string endpoint() const = 0;
  /// Why nobody could be connected, as far as it is known; empty otherwise.
  virtual std::string trouble() { return ""; }
  /// How many messages were no frames.
  std::uint64_t rejected() const { return rejected_; }
  /// Who was not let in.
  const Refusals& refusals() const { return refusals_; }

  /// What signals that something came in: a socket of ZeroMQ, or if null a file descriptor.
  virtual void* zeroMq() const { return nullptr; }
  virtual int file() const { return -1; }

 protected:
  explicit Socket(const Network& network) : network_{network} {}
  /// A frame of this program, at this time.
  Frame frame(FrameKind kind, const Topic& topic) const;

  const Network& network_;
  std::uint64_t rejected_ = 0;
  Refusals refusals_;
};

}  // namespace gt
